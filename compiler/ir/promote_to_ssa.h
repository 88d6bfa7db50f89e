// From variables to values: what analysis and rewriting start from.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// Of the functions of all entry points, whose calls are inlined: blocks that nothing reaches and values that nothing uses are gone,
// local structs and arrays are taken apart (split_variables.h), and variables are
// SSA values where they can be (promote_variables.h). No float operation is changed, folded or moved.
Result<Module> promoteToSsa(const Module& module);

}  // namespace reprise
