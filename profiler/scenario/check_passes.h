// Holds the passes of a scenario against the shaders: part of checkBindings (read_scenario.h).
#pragma once

#include <span>

#include "profiler/scenario/diagnostics.h"
#include "profiler/scenario/scenario.h"
#include "runtime/package/interface.h"

namespace reprise {

// interface: of the scenario's shaders; passes: of each G-buffer pass, by pass.
void checkPasses(const Scenario& scenario, const ShaderInterface& interface, std::span<const ShaderInterface> passes, Diagnostics& diagnostics);

}  // namespace reprise
