// Uses that their definitions no longer dominate, after edges were added to a function.
//
// Such a value is kept in a local variable: stored behind its definition, loaded before the use (promotion makes phis of it). What no
// variable can hold (pointers, images, samplers) is computed again before the use. On the new ways the value is undefined, so this is
// right only where the use does not run there.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

void mendDominance(Module& module, Function& function);

}  // namespace reprise
