#include "fitting/selection/judge.h"

#include <cmath>
#include <cstdio>

namespace reprise {

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string intervalText(const PairedRatio& ratio) {
  return number(ratio.ratio) + "x [" + number(ratio.lo) + ", " + number(ratio.hi) + "]";
}

bool isMeasured(const PairedRatio& ratio) {
  return ratio.pairs > 0 && std::isfinite(ratio.lo) && std::isfinite(ratio.hi);
}

}  // namespace

Judgement judge(const ValidationResult& result, double threshold) {
  const std::string clock = result.clock.empty() ? "the binding clock" : result.clock;
  if (!std::isfinite(result.measured_error) || !isMeasured(result.binding) || !isMeasured(result.wall)) {
    return {false, "judge.unmeasured", "validation gave no usable error or no usable times"};
  }
  if (result.nonfinite_pixels > 0) {
    return {false, "judge.nonfinite",
            std::to_string(result.nonfinite_pixels) + " pixels are NaN or infinite where the original is not"};
  }
  // Written so that a threshold that is NaN accepts nothing.
  if (!(result.measured_error <= threshold)) {
    return {false, "judge.error",
            "measured error " + number(result.measured_error) + " exceeds the threshold " + number(threshold)};
  }
  if (!(result.binding.lo > 1)) {
    return {false, "judge.not_faster",
            "speed-up by " + clock + " is " + intervalText(result.binding) + ": not faster beyond the noise"};
  }
  if (!(result.wall.lo > 1)) {
    return {false, "judge.wall_not_faster",
            "speed-up by wall time is " + intervalText(result.wall) + ": not faster beyond the noise"};
  }
  return {true, "judge.accepted",
          "measured error " + number(result.measured_error) + " is within " + number(threshold) + ", speed-up " +
              intervalText(result.binding) + " by " + clock + " and " + intervalText(result.wall) + " by wall time"};
}

bool worthAnother(const Promise& accepted, double next_predicted_speedup) {
  return accepted.measured_speedup < kPromiseKept * accepted.predicted_speedup && next_predicted_speedup > accepted.measured_speedup;
}

}  // namespace reprise
