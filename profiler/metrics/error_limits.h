// Largest allowed errors that bind together.
//
// With one threshold an error is in the unit of its metric. With several it is the largest share of its threshold that any metric takes,
//
//   ε = max_i ε_i / t_i,
//
// which is allowed up to 1: so one number is modelled, drawn and compared, and it keeps all thresholds where it keeps 1. Wrong as a picture of
// how errors grow where one metric takes over from another: the models then fit the bend less well.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace reprise {

struct Threshold {
  std::string metric;  // of the registry
  double value = 0;    // above 0
  bool operator==(const Threshold&) const = default;
};

struct ErrorLimits {
  std::vector<Threshold> thresholds;  // at least one

  double limit() const { return thresholds.size() == 1 ? thresholds[0].value : 1; }
  std::string unit() const { return thresholds.size() == 1 ? thresholds[0].metric : "share"; }
  std::vector<std::string> metrics() const;

  // From the errors by metric; nullopt where one of them is missing.
  std::optional<double> error(const std::function<std::optional<double>(const std::string& metric)>& errorOf) const;
  bool operator==(const ErrorLimits&) const = default;
};

// "rms 0.02", or "tile_flip 0.03, blocks 0.01"
std::string textOf(const ErrorLimits& limits);

}  // namespace reprise
