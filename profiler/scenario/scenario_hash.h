// The identity of a scenario: what it says and what its texture files hold.
#pragma once

#include <string>

#include "profiler/scenario/scenario.h"

namespace reprise {

// As Scenario::hash says. Errors: those of readTextureFile.
Result<std::string> hashScenario(const Scenario& scenario);

}  // namespace reprise
