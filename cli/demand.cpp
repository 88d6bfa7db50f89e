#include "cli/demand.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "profiler/metrics/metrics.h"
#include "profiler/metrics/quality.h"
#include "profiler/scenario/near_names.h"

namespace reprise {
namespace {

Error usageError(const char* code, std::string message) { return {ErrorKind::kUsage, code, std::move(message), {}}; }

Error unknown(const char* code, const std::string& what, const std::string& name, const std::vector<std::string>& known) {
  const std::vector<std::string> near = nearNames(name, known);
  return usageError(code, fmt::format("there is no {} '{}'; there are {}{}", what, name, fmt::join(known, ", "),
                                      near.empty() ? "" : "; did you mean '" + near.front() + "'?"));
}

Error unknownMetric(const std::string& name) {
  std::vector<std::string> known;
  for (const Metric& metric : metrics()) known.push_back(metric.name);
  return unknown("metric.unknown", "metric", name, known);
}

Result<void> addThreshold(const Threshold& threshold, const std::string& option, Demand& demand) {
  if (findMetric(threshold.metric) == nullptr) return unknownMetric(threshold.metric);
  if (!(threshold.value > 0) || !std::isfinite(threshold.value))
    return usageError("threshold.value", fmt::format("{} is {}; it must be a number above 0, such as 0.02", option, threshold.value));
  for (ErrorLimits* limits : {&demand.binding, &demand.planning}) {
    const auto same = std::find_if(limits->thresholds.begin(), limits->thresholds.end(), [&](const Threshold& one) { return one.metric == threshold.metric; });
    if (same == limits->thresholds.end()) limits->thresholds.push_back(threshold);
    else same->value = std::min(same->value, threshold.value);  // both bind
  }
  return {};
}

Result<Threshold> thresholdFrom(const std::string& text) {
  const std::size_t equals = text.find('=');
  const char* number = equals == std::string::npos ? "" : text.c_str() + equals + 1;
  char* end = nullptr;
  const double value = std::strtod(number, &end);
  if (end == number || *end != '\0')
    return usageError("threshold.value", "--max is '" + text + "'; it must be METRIC=VALUE, such as tile_flip=0.05");
  return Threshold{text.substr(0, equals), value};
}

}  // namespace

Result<Demand> demandOf(const DemandWords& words) {
  Demand demand;
  const bool says_nothing = words.quality.empty() && !words.max_error && words.max.empty();
  if (!words.metric.empty() && findMetric(words.metric) == nullptr) return unknownMetric(words.metric);
  if (!words.metric.empty() && !words.max_error)
    return usageError("metric.alone", "--metric is '" + words.metric + "' without a value for it; say --max-error, too, or --max " + words.metric + "=VALUE");
  if (!words.quality.empty() || says_nothing) {
    const std::string name = words.quality.empty() ? kDefaultQuality : words.quality;
    const Quality* quality = findQuality(name);
    if (quality == nullptr) {
      std::vector<std::string> known;
      for (const Quality& one : qualities()) known.push_back(one.name);
      return unknown("quality.unknown", "quality", name, known);
    }
    demand = {quality->name, quality->binding, quality->planning};
  }
  if (words.max_error) REPRISE_TRY(addThreshold({words.metric.empty() ? "rms" : words.metric, *words.max_error}, "--max-error", demand));
  for (const std::string& text : words.max) {
    REPRISE_ASSIGN(const Threshold threshold, thresholdFrom(text));
    REPRISE_TRY(addThreshold(threshold, "--max " + threshold.metric, demand));
  }
  return demand;
}

}  // namespace reprise
