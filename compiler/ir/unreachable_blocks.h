// Blocks that nothing reaches.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// Without the blocks of a function that nothing reaches. A merge block has to stay, as a branch if it leads straight to a block that is
// reached and else as OpUnreachable, and a continue target, as a branch back to its header; a phi takes an undefined value from there.
void removeUnreachableBlocks(Module& module, Function& function);

// An OpUndef of a type among the globals, found or added.
std::uint32_t undefinedValue(Module& module, std::uint32_t type_id);

}  // namespace reprise
