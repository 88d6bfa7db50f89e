// How often a loop runs, where that is written in the shader.
#pragma once

#include <optional>

#include "compiler/ir/control_flow.h"
#include "compiler/ir/module.h"

namespace reprise {

// Exact where an integer counts by a constant from a constant to a constant and leaves the loop by that alone; a break can end it
// sooner. Nothing elsewhere.
std::optional<int> constantTripCount(const Module& module, const Function& function, const ControlFlow& flow, const Loop& loop);

}  // namespace reprise
