// What a build allows, held against what a committed choice was made under.
#pragma once

#include <string>

#include "cli/choice.h"
#include "cli/demand.h"
#include "runtime/base/result.h"

namespace reprise {

// Holds where every metric that the words bind is bound by the choice, at most as high. Without a word nothing is asked. The original
// has no error, so a choice of it keeps whatever is asked. `scenario` is for the advice only.
// Errors: choice.threshold (kInput; of each metric both numbers), those of demandOf.
Result<void> holdThresholds(const Choice& choice, const DemandWords& words, const std::string& scenario);

}  // namespace reprise
