#include "cli/choice_threshold.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "profiler/metrics/quality.h"

namespace reprise {
namespace {

const Threshold* boundBy(const ErrorLimits& limits, const std::string& metric) {
  const auto found = std::find_if(limits.thresholds.begin(), limits.thresholds.end(), [&](const Threshold& one) { return one.metric == metric; });
  return found == limits.thresholds.end() ? nullptr : &*found;
}

// The word that asks for so little of the metric.
std::string wordOf(const DemandWords& words, const Threshold& asked) {
  const std::string metric = words.metric.empty() ? "rms" : words.metric;
  if (words.max_error && metric == asked.metric && *words.max_error == asked.value) return "--max-error";
  const Quality* quality = findQuality(words.quality);
  const Threshold* of_level = quality == nullptr ? nullptr : boundBy(quality->binding, asked.metric);
  return of_level != nullptr && of_level->value == asked.value ? "--quality " + words.quality : "--max";
}

std::string commandOf(const DemandWords& words, const std::string& scenario) {
  std::string command = "reprise optimize " + scenario;
  if (!words.quality.empty()) command += " --quality " + words.quality;
  for (const std::string& one : words.max) command += " --max " + one;
  if (words.max_error) command += " --max-error " + fmt::format("{}", *words.max_error);
  if (!words.metric.empty()) command += " --metric " + words.metric;
  return command;
}

}  // namespace

Result<void> holdThresholds(const Choice& choice, const DemandWords& words, const std::string& scenario) {
  const bool says_nothing = words.quality.empty() && words.metric.empty() && words.max.empty() && !words.max_error;
  if (says_nothing) return {};
  REPRISE_ASSIGN(const Demand demand, demandOf(words));
  if (choice.is_original) return {};
  std::string broken;
  for (const Threshold& asked : demand.binding.thresholds) {
    const Threshold* allowed = boundBy(choice.limits, asked.metric);
    if (allowed != nullptr && allowed->value <= asked.value) continue;
    broken += (broken.empty() ? "" : "; ") +
              (allowed == nullptr ? fmt::format("the choice does not bind {} (it binds {})", asked.metric, textOf(choice.limits))
                                  : fmt::format("the choice allows {} {}", asked.metric, allowed->value)) +
              fmt::format(", the build asks for at most {} ({})", asked.value, wordOf(words, asked));
  }
  if (broken.empty()) return {};
  return Error{ErrorKind::kInput, "choice.threshold", broken + ": choose again with '" + commandOf(words, scenario) + "'", {}};
}

}  // namespace reprise
