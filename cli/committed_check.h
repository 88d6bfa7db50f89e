// A committed choice as a gate: what was measured now against what the file promises.
//
// The cost is that of the variant over that of the original, cost = 1 / speedup: a ratio of the same run, so that it can be
// compared between machines of one kind. It is too high where cost > recorded cost * (1 + tolerance).
#pragma once

#include <functional>
#include <string>

#include "cli/choice.h"
#include "fitting/selection/judge.h"
#include "runtime/base/result.h"

namespace reprise {

struct CommittedMeasures {
  Judgement judgement;       // of the threshold and of the gain
  double error = 0;          // of the worst session, in the unit of the choice's limits
  double speedup = 0;
  std::string device;
};

struct CommittedCheck {
  std::string sentence;      // what was measured, beside what was recorded
  std::string note;          // where the device is not the recorded one; else empty
};

// Errors (kInput): judge.* (the threshold is exceeded, or it is not faster), validate.cost (too slow by the tolerance).
Result<CommittedCheck> checkCommitted(const Choice& choice, const CommittedMeasures& measured, double cost_tolerance);

// Times vary, errors do not: what fails by its time alone is timed again.
inline constexpr int kMostTimings = 3;
// Whether a failed check is one of times: judge.not_faster, judge.straddles, both by wall time, validate.cost.
bool failedByTime(const Error& error);

// Checks what `measure` gives, which is called with 1 first and whole, then with 2, ... kMostTimings for times alone while the check
// fails by them. The sentence, or the error where it is one of times, says how often it was timed. Errors: of `measure`, of
// checkCommitted.
using MeasureCommitted = std::function<Result<CommittedMeasures>(int timing)>;
Result<CommittedCheck> checkCommittedAgain(const Choice& choice, const MeasureCommitted& measure, double cost_tolerance);

}  // namespace reprise
