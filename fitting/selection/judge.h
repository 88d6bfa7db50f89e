// Law 7, selection keeps its word: a variant is accepted only if its measured validation errors are within their thresholds and it is
// faster than the original by the least gain beyond the noise, by the binding clock and by wall time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fitting/solve/paired_ratio.h"

namespace reprise {

struct JudgedError {
  std::string metric;
  double measured = 0;                 // in the worst validation session
  double allowed = 0;
};

struct ValidationResult {
  std::vector<JudgedError> errors;     // of all binding metrics
  std::uint64_t nonfinite_pixels = 0;  // of the variant where the original is finite
  PairedRatio binding;                 // against the faster of the original and the original with a depth prepass
  PairedRatio wall;                    // the same pairs by wall time
  std::string clock;                   // name of the binding clock, for the reason
};

struct Judgement {
  bool accepted = false;
  std::string code;    // "judge.accepted", "judge.error", "judge.nonfinite", "judge.not_faster", "judge.wall_not_faster",
                       // "judge.straddles", "judge.wall_straddles", "judge.unmeasured"
  std::string reason;  // one sentence with the numbers
};

inline constexpr double kLeastGain = 1.05;

// Accepted: every error ≤ its threshold (the threshold itself, no margin), no pixel made non-finite, and the low ends of both 95% intervals
// above the least gain. An interval that the least gain lies in says neither: "straddles"; more pairs may.
// What was not measured (NaN, no pairs, no errors) is never accepted.
Judgement judge(const ValidationResult& result, double least_gain = kLeastGain);

// Of the errors and pixels alone, before anything is timed: why not accepted; an empty code where they keep the thresholds.
Judgement judgeErrors(const ValidationResult& result);

// Whether to validate one more after a variant was accepted: it reached less than kPromiseKept of the speed-up that was predicted of
// it, and of the next more is predicted than it reached.
inline constexpr double kPromiseKept = 0.9;
struct Promise {
  double predicted_speedup = 1, measured_speedup = 1;
};
bool worthAnother(const Promise& accepted, double next_predicted_speedup);

}  // namespace reprise
