// Chooses among fitted configurations: of all whose predicted error stays under the threshold, the fastest.
//
// For each configuration and allowed period n: error ε̂(n) from its fit (or measured, where that is given; always for "never"),
// frame time r̂(n) · fragments + c with r̂ = λ(n) Δhit + (1 − λ(n)) Δmiss (Eq. 6 of the survey). A point is acceptable if
// ε̂ ≤ threshold · (1 − margin). Each configuration enters the ranking with its fastest acceptable point: the largest
// acceptable n wherever a hit is cheaper than a miss. Ties go to the smaller error.
// Predictions only order the attempts: what is taken has passed validation (judge.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fitting/solve/fit_cost.h"
#include "fitting/solve/fit_error.h"
#include "fitting/solve/fit_hit_rate.h"
#include "runtime/base/result.h"

namespace reprise {

struct AllowedPeriod {
  std::uint32_t period_frames = 1;       // 0: never
  std::optional<double> measured_error;  // taken instead of the fit's; without it "never" is passed over
};

// Everything of a variant but its period, with the models fitted to its rows.
struct Configuration {
  std::string candidate_id;
  std::string strategy, pattern, filter, encoding;
  std::uint32_t block_pixels = 0;
  ErrorFit error_fit;
  HitRateFit hit_rate;
  CostFit cost;
  double fragments_per_frame = 0;  // mean shaded fragments, hits and misses together
  std::vector<AllowedPeriod> periods;
};

struct SelectionInput {
  std::vector<Configuration> configurations;
  double original_frame_ms = 0;  // the faster of the original and the original with a depth prepass, binding clock
};

struct SelectionOptions {
  double threshold = 0;          // of the binding metric, ≥ 0
  double error_margin = 0.1;     // in [0, 1): share of the threshold kept free for what training has not seen
  double least_speedup = 1;      // predicted speed-ups must exceed it
  bool shorter_periods = false;  // rank all acceptable points, so that a choice that fails for its error can be tried again
                                 // at a shorter period; else one point per configuration
};

// One configuration at one period.
struct TradeoffPoint {
  std::size_t configuration = 0;  // index into SelectionInput::configurations
  std::uint32_t period_frames = 1;
  double predicted_error = 0;
  double predicted_error_hi = 0;  // end of the 95% interval; the error itself where it was measured
  bool error_measured = false;
  double predicted_hit_rate = 0;
  double predicted_frame_ms = 0;
  double predicted_speedup = 0;   // original_frame_ms / predicted_frame_ms
  bool operator==(const TradeoffPoint&) const = default;
};

struct DroppedConfiguration {
  std::size_t configuration = 0;
  std::string code;     // "selection.no_model", "selection.error", "selection.slow"
  std::string message;  // one sentence with the numbers
};

struct Selection {
  std::vector<TradeoffPoint> ranking;  // acceptable and predicted faster, fastest first: [0] is the choice, the rest are the
                                       // runners-up, in the order in which validation should try them
  std::vector<TradeoffPoint> points;   // all that could be predicted, by configuration, then by period (never last)
  std::vector<TradeoffPoint> pareto;   // those that no other beats in error and in time, by ascending error; the original
                                       // is not among them
  std::vector<DroppedConfiguration> dropped;  // configurations without a place in the ranking
  std::string original_reason_code;    // empty if the ranking is not; else "selection.no_model", "selection.error",
                                       // "selection.slow", "selection.no_candidates"
  std::string original_reason;         // one sentence: why the answer is the original
};

// Errors (kInput): selection.threshold (negative or not a number), selection.margin (outside [0, 1)), selection.original (no
// positive frame time of the original).
Result<Selection> select(const SelectionInput& input, const SelectionOptions& options);

}  // namespace reprise
