// Training rows into the models that selection works on (stage 8).
#pragma once

#include <string>
#include <vector>

#include "cli/subject.h"
#include "cli/trained.h"
#include "fitting/selection/select.h"

namespace reprise {

// 0 for patterns without blocks.
std::uint32_t blockPixels(const VariantOptions& options);

struct FittedTraining {
  SelectionInput input;                   // one configuration for each cost study with a usable error study
  std::vector<std::size_t> cost_study;    // by configuration: index into Training::costs
};

// Points of an error study: one for each period with settled frames, over all its sessions.
std::vector<ErrorPoint> errorPoints(const ErrorStudy& study, const ErrorLimits& limits);
ErrorFit fitErrors(const ErrorStudy& study, const ErrorLimits& limits);
// The error of "never", measured directly; nullopt if that period was not trained.
std::optional<double> neverError(const ErrorStudy& study, const ErrorLimits& limits);

// Frames that were both timed and counted: Eq. 5 wants the fragments of the very frame.
struct TimedCount {
  std::uint32_t period_frames = 1;
  CostPoint point;
};
std::vector<TimedCount> timedAndCounted(const ErrorStudy& errors, const CostStudy& costs);

FittedTraining fitTraining(const Subject& subject, const Training& training, const ErrorLimits& limits);

// One warning with the worst figures where training frames cannot tell the cost model's terms apart (cost_design.h); else none.
std::vector<std::string> costWarnings(const Training& training);

// Median frame time of the faster of the original and the original behind a prepass (ms of the binding clock).
double originalFrameMs(const Training& training);

}  // namespace reprise
