// What goes into a fragment and what comes out of it.
#pragma once

#include "cli/check/interpreter/machine.h"

namespace reprise::interpreter {

// The module's variables: varyings and built-ins made up, others undefined or as initialized. Machine::setUp has run.
void setUpMemory(Machine& machine);

// By location and component.
std::vector<OutputWord> outputsOf(const Machine& machine);

}  // namespace reprise::interpreter
