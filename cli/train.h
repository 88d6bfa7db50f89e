// Training: which variants are measured, in which order, and what came out (stage 7).
//
// The order of work, each step a prefix of the next larger run (law 9):
//   1 probe     ranges of payload and depth, at a quarter of the resolution, for every candidate
//               then what share of the objects has misses, which decides whether leaving out the others is timed
//   2 errors    of the first training session: every candidate in the base configuration (bilinear, rgba16f, interleaved 16), all periods;
//               first of as many candidates as are timed, then of the others, if no more than 0.3 of the budget is gone by then
//   3 costs     in the same session: the candidates whose error there allows any period but 1, in every strategy that the state
//               allows, at the shortest period and at the longest that the error allows, with the original, the original behind a
//               prepass and the tail-only limit in the same run; then 2 and 3 for the next session
//   4 refine    the fastest configuration so far with other filters, encodings and patterns: errors at its period, the shortest
//               and the longest, then costs in its strategy, again session by session
// A job that the budget ends is lost; what was not reached is said.
#pragma once

#include <functional>
#include <string>

#include "cli/budget.h"
#include "cli/progress.h"
#include "cli/subject.h"
#include "cli/trained.h"
#include "cli/workspace.h"
#include "profiler/training/measure.h"

namespace reprise {

struct TrainOptions {
  ErrorLimits limits;             // that errors are modelled for: cheap metrics
  const Budget* budget = nullptr; // of which training has kTrainingShare; none: as long as it takes
  std::size_t timed_candidates = 3;
  int rounds = 20;
  bool cpu_clock = true;           // the binding clock: process CPU time, else time stamps
};

// `measuring` is ready but for its progress callback. Errors: kInterrupted and kMachine; failures of variants are rows.
Result<Training> train(const Subject& subject, const Workspace& workspace, const Measuring& measuring, const TrainOptions& options,
                       Progress& progress);

// The options of a variant of this subject in the base configuration, with the ranges seen.
VariantOptions baseOptions(const Subject& subject, const ValueRanges& ranges, const Candidate& candidate = {});

}  // namespace reprise
