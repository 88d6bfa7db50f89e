// Why the original shader is the answer, in one sentence.
#pragma once

#include <string>

#include "cli/report/result.h"
#include "fitting/selection/select.h"

namespace reprise {

// Reads of `run` the candidates with their points, the attempts, the threshold and what was not reached.
std::string explainOriginal(const RunResult& run, const Selection& selection);

}  // namespace reprise
