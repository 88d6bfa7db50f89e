#include "profiler/session/job_json.h"

#include <limits>
#include <nlohmann/json.hpp>

namespace reprise {

using nlohmann::json;

NLOHMANN_JSON_SERIALIZE_ENUM(JobKind, {{JobKind::kErrors, "errors"}, {JobKind::kTimes, "times"}, {JobKind::kProbe, "probe"},
                                       {JobKind::kObjects, "objects"}, {JobKind::kImages, "images"}, {JobKind::kReference, "reference"},
                                       {JobKind::kLaws, "laws"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JobEntry, package_dir, period_frames, tolerance, most_difference)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Job, kind, scenario_path, session, original_dir, entries, metrics, frames, rounds, warmup_frames, width,
                                   height, device, image_frame, image_dir, strip_frames, reference_dir, fence_timeout_s, run_id)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ObjectCounts, drawn, flagged)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LawDifference, law, frame, output, x, y, expected, found, kind, pixels, visible)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TimeRow, run_id, pair, frame, gpu_ms, wall_ms, cpu_ms)

namespace {

json errorRowJson(const ErrorRow& row) {
  json errors = json::object();
  // JSON has no NaN; null stands for it.
  for (const auto& [name, value] : row.errors) errors[name] = value;
  return {{"frame", row.frame}, {"covered", row.covered}, {"hits", row.hits}, {"misses", row.misses},
          {"shaded_hits", row.shaded_hits}, {"shaded_misses", row.shaded_misses}, {"nonfinite", row.nonfinite}, {"spoiled", row.spoiled}, {"errors", errors},
          {"tiles", row.tiles}};
}

ErrorRow errorRowFrom(const json& from) {
  ErrorRow row;
  row.frame = from.at("frame");
  row.covered = from.at("covered");
  row.hits = from.at("hits");
  row.misses = from.at("misses");
  row.shaded_hits = from.at("shaded_hits");
  row.shaded_misses = from.at("shaded_misses");
  row.nonfinite = from.at("nonfinite");
  row.spoiled = from.at("spoiled");
  for (const auto& [name, value] : from.at("errors").items())
    row.errors[name] = value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
  row.tiles = from.at("tiles").get<std::map<std::string, std::vector<std::uint16_t>>>();
  return row;
}

json probeJson(const ProbeResult& probe) {
  return {{"entry", probe.entry}, {"payload_min", probe.payload_min}, {"payload_max", probe.payload_max}, {"payload_change", probe.payload_change},
          {"depth_min", probe.depth_min}, {"depth_max", probe.depth_max}, {"nonfinite_payload", probe.nonfinite_payload}, {"nonfinite_color", probe.nonfinite_color},
          {"covered", probe.covered}};
}

ProbeResult probeFrom(const json& from) {
  ProbeResult probe;
  probe.entry = from.at("entry");
  probe.payload_min = from.at("payload_min").get<ChannelFloats>();
  probe.payload_max = from.at("payload_max").get<ChannelFloats>();
  probe.payload_change = from.at("payload_change").get<ChannelFloats>();
  probe.depth_min = from.at("depth_min");
  probe.depth_max = from.at("depth_max");
  probe.nonfinite_payload = from.at("nonfinite_payload");
  probe.nonfinite_color = from.at("nonfinite_color");
  probe.covered = from.at("covered");
  return probe;
}

json lawJson(const LawOutcome& outcome) {
  const auto orNull = [](const std::optional<LawDifference>& one) { return one ? json(*one) : json(nullptr); };
  return {{"difference", orNull(outcome.difference)}, {"rounding", orNull(outcome.rounding)}, {"frozen_hits", outcome.frozen_hits}};
}

LawOutcome lawFrom(const json& from) {
  const auto orNone = [](const json& one) { return one.is_null() ? std::nullopt : std::optional(one.get<LawDifference>()); };
  return {orNone(from.at("difference")), orNone(from.at("rounding")), from.at("frozen_hits").get<std::uint64_t>()};
}

}  // namespace

json resultJson(const JobResult& result) {
  json errors = json::array(), probes = json::array(), laws = json::array();
  for (const auto& rows : result.errors) {
    json list = json::array();
    for (const ErrorRow& row : rows) list.push_back(errorRowJson(row));
    errors.push_back(std::move(list));
  }
  for (const ProbeResult& probe : result.probes) probes.push_back(probeJson(probe));
  for (const LawOutcome& outcome : result.laws) laws.push_back(lawJson(outcome));
  return {{"device", result.device}, {"driver", result.driver}, {"cpu_device", result.cpu_device}, {"errors", std::move(errors)},
          {"times", result.times}, {"probes", std::move(probes)}, {"objects", result.objects}, {"laws", std::move(laws)}, {"images", result.images}};
}

JobResult resultFrom(const json& from) {
  JobResult result;
  result.device = from.at("device");
  result.driver = from.at("driver");
  result.cpu_device = from.at("cpu_device");
  for (const json& list : from.at("errors")) {
    std::vector<ErrorRow> rows;
    for (const json& row : list) rows.push_back(errorRowFrom(row));
    result.errors.push_back(std::move(rows));
  }
  result.times = from.at("times").get<std::vector<std::vector<TimeRow>>>();
  for (const json& probe : from.at("probes")) result.probes.push_back(probeFrom(probe));
  result.objects = from.at("objects").get<std::vector<ObjectCounts>>();
  for (const json& outcome : from.at("laws")) result.laws.push_back(lawFrom(outcome));
  result.images = from.at("images").get<std::vector<std::string>>();
  return result;
}

json errorJson(const Error& error) {
  json others = json::array();
  for (const Error& other : error.others) others.push_back(errorJson(other));
  return {{"kind", static_cast<int>(error.kind)}, {"code", error.code}, {"message", error.message}, {"file", error.place.file},
          {"line", error.place.line}, {"column", error.place.column}, {"others", std::move(others)}};
}

Error errorFrom(const json& from) {
  Error error{static_cast<ErrorKind>(from.at("kind").get<int>()), from.at("code"), from.at("message"), {from.at("file"), from.at("line"), from.at("column")}};
  for (const json& other : from.at("others")) error.others.push_back(errorFrom(other));
  return error;
}

std::string jobToJson(const Job& job) { return json(job).dump(); }

Result<Job> jobFromJson(const std::string& text) {
  try {
    return json::parse(text).get<Job>();
  } catch (const std::exception& failure) {
    return Error{ErrorKind::kInput, "job.syntax", std::string("this is no job: ") + failure.what(), {}};
  }
}

}  // namespace reprise
