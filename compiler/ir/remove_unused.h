// Values that nothing uses.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// Without the instructions of all functions whose results no side effect, branch or return needs: pure ones, loads, and stores to
// local variables that are never read. Branches stay as they are.
Module removeUnused(const Module& module);

}  // namespace reprise
