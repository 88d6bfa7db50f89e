#include "profiler/metrics/error_limits.h"

#include <cmath>
#include <cstdio>

namespace reprise {

std::vector<std::string> ErrorLimits::metrics() const {
  std::vector<std::string> names;
  for (const Threshold& threshold : thresholds) names.push_back(threshold.metric);
  return names;
}

std::optional<double> ErrorLimits::error(const std::function<std::optional<double>(const std::string&)>& errorOf) const {
  std::optional<double> largest;
  for (const Threshold& threshold : thresholds) {
    const std::optional<double> error = errorOf(threshold.metric);
    if (!error) return std::nullopt;
    const double share = thresholds.size() == 1 ? *error : *error / threshold.value;
    if (!largest || !(share <= *largest)) largest = share;
    if (std::isnan(share)) return share;
  }
  return largest;
}

std::string textOf(const ErrorLimits& limits) {
  std::string text;
  for (const Threshold& threshold : limits.thresholds) {
    char value[32];
    std::snprintf(value, sizeof value, " %.4g", threshold.value);
    text += (text.empty() ? "" : ", ") + threshold.metric + value;
  }
  return text;
}

}  // namespace reprise
