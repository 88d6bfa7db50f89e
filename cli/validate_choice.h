// Validation: the choice on sessions that no fit has seen, timed anew (stage 10; law 7).
#pragma once

#include <string>
#include <vector>

#include "cli/progress.h"
#include "cli/subject.h"
#include "cli/trained.h"
#include "cli/workspace.h"
#include "fitting/selection/judge.h"
#include "fitting/solve/paired_ratio.h"
#include "profiler/training/measure.h"

namespace reprise {

struct ValidationPlan {
  std::size_t candidate = 0;
  VariantOptions options;      // with the period to validate
  std::vector<std::string> packages = {};  // of this variant on disk, such as the one that ships: held to the original, too
  ErrorLimits limits;
  double least_gain = kLeastGain;
  int rounds = 30;             // per session
  bool cpu_clock = true;
};

struct ValidatedSession {
  std::string name;
  std::vector<ErrorRow> rows;
  std::vector<TimedFrame> variant, reference;  // by round
};

// One metric over the validation.
struct MetricOutcome {
  std::string metric;
  double all_sessions = 0, worst_session = 0, worst_frame = 0;
};

struct ValidationRun {
  std::vector<ValidatedSession> sessions;
  double measured_error = 0;        // in the unit of the limits, as the next two; all sessions together
  double worst_session_error = 0;   // what the limits are held against
  double worst_frame_error = 0;
  std::vector<MetricOutcome> metrics;  // of the registry: the cheap ones, and those that bind
  double hit_rate = 0;              // of covered pixels, settled frames
  PairedRatio binding, wall;        // against the faster of the original and the original with a prepass
  std::string reference;            // which that was: "original" or "original_prepass"
  double original_ms = 0, original_wall_ms = 0, prepass_ms = 0, limit_ms = 0;  // medians; NaN where not measured
  double fragments_per_frame = 0;
  std::uint64_t spoiled = 0;        // pixels that are not finite where the original is
  Judgement judgement;
};

// First the variant's packages are held to the original (hold_laws.h); nothing is measured of one that differs, and it is judged by that.
// Errors: kInterrupted, kMachine; a variant that fails to run is judged "judge.unmeasured".
Result<ValidationRun> validateChoice(const Subject& subject, const Workspace& workspace, const Measuring& measuring,
                                     const ValidationPlan& plan, Progress& progress);

// The times alone once more, which judge `run` anew: its errors are what they are. Only for a run that was timed. Errors: as above.
Result<void> timeAgain(const Subject& subject, const Workspace& workspace, const Measuring& measuring, const ValidationPlan& plan,
                       Progress& progress, ValidationRun& run);

}  // namespace reprise
