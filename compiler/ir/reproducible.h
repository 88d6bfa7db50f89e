// Modules whose results do not depend on what a compiler makes of freedoms that the specification leaves it.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// Undefined values made zero (the first component, in a shuffle): OpUndef, variables of the function and the module that have no initializer, and outputs before their
// first store. Values that have no zero (images, pointers) are left as they are.
Module withDefinedValues(const Module& module);

// Every arithmetic instruction on floats decorated NoContraction: no fused, reassociated or distributed operations.
Module withoutContraction(const Module& module);

}  // namespace reprise
