#include "fitting/selection/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

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

struct ErrorLists {
  std::string within, beyond;
};

ErrorLists listErrors(const std::vector<JudgedError>& errors) {
  ErrorLists lists;
  for (const JudgedError& error : errors) {
    // Written so that a threshold that is NaN accepts nothing.
    const bool keeps = error.measured <= error.allowed;
    std::string& list = keeps ? lists.within : lists.beyond;
    list += (list.empty() ? "" : ", ") + error.metric + " " + number(error.measured) + (keeps ? " within " : " exceeds ") + number(error.allowed);
  }
  return lists;
}

bool areMeasured(const std::vector<JudgedError>& errors) {
  return !errors.empty() && std::all_of(errors.begin(), errors.end(), [](const JudgedError& error) { return std::isfinite(error.measured); });
}

bool isMeasured(const PairedRatio& ratio) {
  return ratio.pairs > 0 && std::isfinite(ratio.lo) && std::isfinite(ratio.hi);
}

}  // namespace

Judgement judgeErrors(const ValidationResult& result) {
  if (!areMeasured(result.errors)) return {false, "judge.unmeasured", "validation gave no usable error"};
  if (result.nonfinite_pixels > 0) {
    return {false, "judge.nonfinite",
            std::to_string(result.nonfinite_pixels) + " pixels are NaN or infinite where the original is not"};
  }
  const ErrorLists lists = listErrors(result.errors);
  if (lists.beyond.empty()) return {};
  return {false, "judge.error", "measured " + lists.beyond + (lists.within.empty() ? "" : " (" + lists.within + ")")};
}

Judgement judge(const ValidationResult& result, double least_gain) {
  if (Judgement errors = judgeErrors(result); !errors.code.empty()) return errors;
  if (!isMeasured(result.binding) || !isMeasured(result.wall)) return {false, "judge.unmeasured", "validation gave no usable times"};
  const std::string clock = result.clock.empty() ? "the binding clock" : result.clock;
  for (const auto& [ratio, name, prefix] : {std::tuple(&result.binding, clock, ""), {&result.wall, std::string("wall time"), "wall_"}}) {
    if (ratio->lo > least_gain) continue;
    const bool open = ratio->hi > least_gain;
    return {false, std::string("judge.") + prefix + (open ? "straddles" : "not_faster"),
            "speed-up by " + name + " is " + intervalText(*ratio) + ", " +
                (open ? "which may be more or less than the least gain of " : "not more than the least gain of ") + number(least_gain) + "x"};
  }
  return {true, "judge.accepted",
          "measured " + listErrors(result.errors).within + "; speed-up " + intervalText(result.binding) + " by " + clock + " and " +
              intervalText(result.wall) + " by wall time"};
}

bool worthAnother(const Promise& accepted, double next_predicted_speedup) {
  return accepted.measured_speedup < kPromiseKept * accepted.predicted_speedup && next_predicted_speedup > accepted.measured_speedup;
}

}  // namespace reprise
