// What the run answers where no variant was accepted: the original, or that not enough was measured to say so.
#pragma once

#include <string>

#include "cli/report/result.h"
#include "fitting/selection/select.h"

namespace reprise {

struct Measured {
  const Selection& selection;
  bool budget_ended = false;     // before all that was planned was measured
  bool none_validated = false;   // there were attempts, and none could be measured
  bool more_to_validate = false; // variants that were predicted to do, and were not tried
};

struct Answer {
  ChoiceKind kind = ChoiceKind::kOriginal;  // or kUndecided
  std::string reason;                       // of the original: the best variant's numbers; else what is missing and how to go on
};

// Reads of `run` the candidates with their points, the attempts, the thresholds and what was not reached.
Answer answerWithoutVariant(const RunResult& run, const Measured& measured);

}  // namespace reprise
