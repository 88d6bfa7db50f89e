// Variants of one scenario, timed against its original in one run.
#pragma once

#include "cli/subject.h"
#include "cli/workspace.h"
#include "profiler/session/job.h"

namespace reprise {

struct TimedVariant {
  std::string strategy, variant;
  VariantOptions options;
  StoredVariant stored;
  std::vector<double> clock_ms;  // by round, of the binding clock: process CPU time on a CPU device, else time stamps
};

struct VariantTiming {
  std::string worker_path, device, session;
  std::uint32_t period_frames = 16;
  int rounds = 20;
};

// Fills clock_ms, alternating through all variants; the first is the original. Errors: of superviseJob.
Result<void> timeVariants(const VariantTiming& plan, const Workspace& workspace, std::vector<TimedVariant>& timed);

// Index of the kept candidate that saves most among those that stick to the surface: no uniform is among their inputs. 0 if there is none.
std::size_t surfacePayload(const Subject& subject);

}  // namespace reprise
