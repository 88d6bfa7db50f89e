#include "cli/choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "profiler/metrics/metrics.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

using Json = nlohmann::json;

// The shortest decimal that reads back as the same float, instead of the double's that it equals.
double shortest(float value) { return std::stod(fmt::format("{}", value)); }

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::optional<double> numberOrNone(const Json& from, const char* key) {
  const Json& value = from.at(key);
  return value.is_null() ? std::nullopt : std::optional<double>(value.get<double>());
}

// Up to the last channel that was seen to hold anything.
std::size_t channelsOf(const ValueRanges& ranges) {
  std::size_t channels = kMostPayloadChannels;
  while (channels > 0 && ranges.payload_min[channels - 1] == 0 && ranges.payload_max[channels - 1] == 0) --channels;
  return channels;
}

Json rangesJson(const ValueRanges& ranges) {
  Json low = Json::array(), high = Json::array();
  for (std::size_t channel = 0; channel < channelsOf(ranges); ++channel) {
    low.push_back(shortest(ranges.payload_min[channel]));
    high.push_back(shortest(ranges.payload_max[channel]));
  }
  return {{"depth_near", shortest(ranges.depth_near)}, {"depth_far", shortest(ranges.depth_far)}, {"payload_min", low}, {"payload_max", high}};
}

ValueRanges rangesFrom(const Json& from) {
  ValueRanges ranges;
  ranges.depth_near = from.at("depth_near").get<float>();
  ranges.depth_far = from.at("depth_far").get<float>();
  const auto low = from.at("payload_min").get<std::vector<float>>(), high = from.at("payload_max").get<std::vector<float>>();
  if (low.size() != high.size() || low.size() > kMostPayloadChannels)
    throw std::runtime_error(fmt::format("payload_min and payload_max must have equally many values, at most {}", kMostPayloadChannels));
  std::copy(low.begin(), low.end(), ranges.payload_min.begin());
  std::copy(high.begin(), high.end(), ranges.payload_max.begin());
  return ranges;
}

Json variantJson(const VariantOptions& variant) {
  return {{"strategy", variant.strategy}, {"pattern", nameOf(variant.pattern)}, {"block_pixels", variant.block_pixels},
          {"filter", nameOf(variant.filter)}, {"encoding", nameOf(variant.encoding)},
          {"period_frames", variant.period_frames == kNeverRefresh ? Json(nullptr) : Json(variant.period_frames)},
          {"ranges", rangesJson(variant.ranges)}};
}

template <typename Enum>
Enum namedIn(const Json& from, const char* key, std::optional<Enum> (*valueOf)(const std::string&)) {
  const std::string name = from.at(key).get<std::string>();
  const std::optional<Enum> value = valueOf(name);
  if (!value) throw std::runtime_error(fmt::format("'{}' is no {} that this version knows", name, key));
  return *value;
}

VariantOptions variantFrom(const Json& from) {
  VariantOptions variant;
  variant.strategy = from.at("strategy").get<std::string>();
  const Strategy* strategy = findStrategy(variant.strategy);
  if (strategy == nullptr || !strategy->selectable)
    throw std::runtime_error(fmt::format("'{}' is no strategy that this version can choose", variant.strategy));
  variant.pattern = namedIn(from, "pattern", &patternKindOf);
  variant.filter = namedIn(from, "filter", &filterOf);
  variant.encoding = namedIn(from, "encoding", &encodingOf);
  variant.block_pixels = from.at("block_pixels").get<std::uint32_t>();
  if (!std::has_single_bit(variant.block_pixels) || variant.block_pixels < 2 || variant.block_pixels > 256)
    throw std::runtime_error("block_pixels must be a power of two from 2 to 256");
  variant.period_frames = from.at("period_frames").is_null() ? kNeverRefresh : from.at("period_frames").get<std::uint32_t>();
  if (variant.period_frames != kNeverRefresh && (!std::has_single_bit(variant.period_frames) || variant.period_frames > 64))
    throw std::runtime_error("period_frames must be 1, 2, 4, ... 64 or null for never");
  variant.ranges = rangesFrom(from.at("ranges"));
  return variant;
}

Json valueJson(const IdentifiedValue& value) {
  Json json = {{"slice", value.slice}, {"shape", value.shape}, {"name", value.name}, {"operation", value.operation}, {"type", value.type},
               {"file", value.file}, {"line", value.line}, {"operations", value.operations}, {"inputs", value.inputs}};
  if (!value.text.empty()) json["slice_text"] = value.text;
  if (!value.chain.empty()) json["part_of"] = {{"chain", value.chain}, {"kept_terms", value.terms}};
  return json;
}

IdentifiedValue valueFrom(const Json& from) {
  IdentifiedValue value;
  for (const auto& [key, member] : {std::pair{"slice", &value.slice}, {"shape", &value.shape}, {"name", &value.name},
                                    {"operation", &value.operation}, {"type", &value.type}, {"file", &value.file}})
    *member = from.at(key).get<std::string>();
  value.line = from.at("line").get<int>();
  value.operations = from.at("operations").get<std::map<std::string, int>>();
  value.inputs = from.at("inputs").get<std::vector<std::string>>();
  if (const auto text = from.find("slice_text"); text != from.end()) value.text = text->get<std::vector<std::string>>();
  if (const auto part = from.find("part_of"); part != from.end()) {
    value.chain = part->at("chain").get<std::string>();
    value.terms = part->at("kept_terms").get<std::vector<std::string>>();
  }
  return value;
}

void addMeasured(const Choice& choice, Json& json) {
  const ChosenMeasures& measured = choice.measured;
  json["measured"] = {{"error", orNull(measured.error)}, {"speedup", orNull(measured.speedup)}, {"speedup_low", orNull(measured.speedup_low)},
                      {"speedup_high", orNull(measured.speedup_high)}, {"frame_ms", orNull(measured.frame_ms)},
                      {"original_frame_ms", orNull(measured.original_frame_ms)}};
  const ChosenModels& models = choice.models;
  json["models"] = {{"error", {{"family", models.error_family}, {"parameters", models.error_parameters}}},
                    {"cost", {{"hit_ns", orNull(models.hit_ns)}, {"miss_ns", orNull(models.miss_ns)}, {"overhead_ms", orNull(models.overhead_ms)}}},
                    {"hit_rate_mu", orNull(models.hit_rate_mu)}};
}

void readMeasured(const Json& json, Choice& choice) {
  const Json& measured = json.at("measured");
  choice.measured = {numberOrNone(measured, "error"), numberOrNone(measured, "speedup"), numberOrNone(measured, "speedup_low"),
                     numberOrNone(measured, "speedup_high"), numberOrNone(measured, "frame_ms"), numberOrNone(measured, "original_frame_ms")};
  const Json& models = json.at("models");
  choice.models.error_family = models.at("error").at("family").get<std::string>();
  choice.models.error_parameters = models.at("error").at("parameters").get<std::map<std::string, double>>();
  const Json& cost = models.at("cost");
  choice.models.hit_ns = numberOrNone(cost, "hit_ns");
  choice.models.miss_ns = numberOrNone(cost, "miss_ns");
  choice.models.overhead_ms = numberOrNone(cost, "overhead_ms");
  choice.models.hit_rate_mu = numberOrNone(models, "hit_rate_mu");
}

Json thresholdsJson(const ErrorLimits& limits) {
  Json list = Json::array();
  for (const Threshold& threshold : limits.thresholds) list.push_back({{"metric", threshold.metric}, {"value", threshold.value}});
  return list;
}

// A file of format 1 has a single threshold and no gain.
void readLimits(const Json& json, Choice& choice) {
  const auto add = [&](const Json& one) {
    const Threshold threshold{one.at("metric").get<std::string>(), one.at("value").get<double>()};
    if (findMetric(threshold.metric) == nullptr) throw std::runtime_error(fmt::format("'{}' is no metric that this version knows", threshold.metric));
    if (!(threshold.value > 0)) throw std::runtime_error("a threshold must be above 0");
    choice.limits.thresholds.push_back(threshold);
  };
  if (!json.contains("thresholds")) return add(json.at("threshold"));
  for (const Json& one : json.at("thresholds")) add(one);
  if (choice.limits.thresholds.empty()) throw std::runtime_error("a choice needs a threshold");
  if (!json.at("quality").is_null()) choice.quality = json.at("quality").get<std::string>();
  choice.least_gain = json.at("least_gain").get<double>();
}

Choice choiceFrom(const Json& json) {
  Choice choice;
  choice.tool_version = json.at("tool_version").get<std::string>();
  const std::string kind = json.at("kind").get<std::string>();
  if (kind != "variant" && kind != "original") throw std::runtime_error("kind must be \"variant\" or \"original\"");
  choice.is_original = kind == "original";
  choice.reason = json.at("reason").get<std::string>();
  choice.scenario_file = json.at("scenario").at("file").get<std::string>();
  choice.scenario_hash = json.at("scenario").at("hash").get<std::string>();
  choice.shader_hash = json.at("shader_hash").get<std::string>();
  readLimits(json, choice);
  const Json& device = json.at("device");
  choice.device = {device.at("name").get<std::string>(), device.at("driver").get<std::string>(), device.at("clock").get<std::string>()};
  if (choice.is_original) return choice;
  choice.candidate_id = json.at("candidate").get<std::string>();
  for (const Json& value : json.at("payload")) choice.payload.push_back(valueFrom(value));
  if (choice.payload.empty()) throw std::runtime_error("a variant needs a payload");
  choice.variant = variantFrom(json.at("variant"));
  readMeasured(json, choice);
  return choice;
}

}  // namespace

std::string choiceToJson(const Choice& choice) {
  Json json = {{"format_version", kChoiceFormatVersion},
               {"tool_version", choice.tool_version},
               {"kind", choice.is_original ? "original" : "variant"},
               {"reason", choice.reason},
               {"scenario", {{"file", choice.scenario_file}, {"hash", choice.scenario_hash}}},
               {"shader_hash", choice.shader_hash},
               {"quality", choice.quality.empty() ? Json(nullptr) : Json(choice.quality)},
               {"thresholds", thresholdsJson(choice.limits)},
               {"least_gain", choice.least_gain},
               {"device", {{"name", choice.device.name}, {"driver", choice.device.driver}, {"clock", choice.device.clock}}}};
  if (!choice.is_original) {
    json["candidate"] = choice.candidate_id;
    json["payload"] = Json::array();
    for (const IdentifiedValue& value : choice.payload) json["payload"].push_back(valueJson(value));
    json["variant"] = variantJson(choice.variant);
    addMeasured(choice, json);
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Choice> readChoice(const std::string& file) {
  std::error_code status;
  if (!std::filesystem::exists(file, status))
    return Error{ErrorKind::kInput, "choice.missing",
                 "there is no choice '" + file + "'; 'reprise optimize' writes one as choice.json into its output directory", {}};
  REPRISE_ASSIGN(const std::string text, readFile(file));
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::exception& failure) {
    return Error{ErrorKind::kInput, "choice.syntax", std::string("the choice is no JSON (conflict markers of a merge?): ") + failure.what(), {file, 0, 0}};
  }
  try {
    const int version = json.at("format_version").get<int>();
    if (version > kChoiceFormatVersion)
      return Error{ErrorKind::kInput, "choice.version",
                   fmt::format("the choice has format {} and was made by reprise {}; this version reads up to {}: update Reprise or choose again",
                               version, json.value("tool_version", "of a later version"), kChoiceFormatVersion), {file, 0, 0}};
    return choiceFrom(json);
  } catch (const std::exception& failure) {
    return Error{ErrorKind::kInput, "choice.invalid", std::string("the choice cannot be read: ") + failure.what(), {file, 0, 0}};
  }
}

}  // namespace reprise
