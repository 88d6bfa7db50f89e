// What the user allows: the words of the command line as thresholds that bind together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "profiler/metrics/error_limits.h"
#include "runtime/base/result.h"

namespace reprise {

struct DemandWords {
  std::string quality;              // of qualities(); "": none was named
  std::optional<double> max_error;  // of `metric`
  std::string metric;               // "": rms
  std::vector<std::string> max;     // "METRIC=VALUE"
};

struct Demand {
  std::string quality;      // the level, if one binds; else ""
  ErrorLimits binding;      // what validation holds
  ErrorLimits planning;     // what training models
  bool operator==(const Demand&) const = default;
};

// The level is kDefaultQuality where nothing was said. Errors (kUsage): quality.unknown, metric.unknown (with those that there are),
// metric.alone (a metric without its value), threshold.value (not a number above 0). Of a metric that is named twice the smaller value binds.
Result<Demand> demandOf(const DemandWords& words);

}  // namespace reprise
