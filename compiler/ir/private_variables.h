// Variables of the module that only one function uses.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// Private variables that all uses of are in one function, an entry point's, become local variables of it; an initializer becomes a
// store at its start, as it takes effect once an invocation. For modules whose calls are inlined.
Module privatesToLocals(const Module& module);

}  // namespace reprise
