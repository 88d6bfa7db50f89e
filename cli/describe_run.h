// The values of a run as result.json holds them.
#pragma once

#include <string>
#include <vector>

#include "cli/fit.h"
#include "cli/report/result.h"
#include "cli/subject.h"
#include "cli/trained.h"
#include "cli/validate_choice.h"

namespace reprise {

struct ValidationAttempt {
  std::size_t configuration = 0;  // index into FittedTraining::input.configurations
  TradeoffPoint point;
  ValidationRun run;
};

// All candidates with their models, configurations and points, or the reason why they have none.
std::vector<RunCandidate> describeCandidates(const Subject& subject, const Training& training, const FittedTraining& fitted,
                                             const Selection& selection, const ErrorLimits& limits);

RunVariant describeVariant(const Configuration& configuration, std::uint32_t period_frames);

// Models of the choice that are not to be trusted, one sentence each: a fit that its points do not follow, a cost model whose terms
// the sessions' coverage cannot tell apart.
std::vector<std::string> fitWarnings(const RunResult& result);

RunAttempt describeAttempt(const FittedTraining& fitted, const ValidationAttempt& attempt);

// The accepted attempt as the run's choice, original, limit and validation.
void describeAccepted(const Subject& subject, const Training& training, const FittedTraining& fitted, const ValidationAttempt& attempt,
                      RunResult& result);

// What bound a run; of one by an earlier version, its only threshold.
ErrorLimits limitsOf(const RunResult& result);

// The metrics over the validation, side by side.
std::vector<RunMetric> describeMetrics(const ValidationRun& run);

std::vector<RunSession> describeSessions(const ValidationRun& run, const ErrorLimits& limits);

}  // namespace reprise
