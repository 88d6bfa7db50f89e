// Modules whose results do not depend on what a compiler makes of freedoms that the specification leaves it.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// Undefined values made zero (the first component, in a shuffle): OpUndef, variables of the function and the module that have no initializer, and outputs before their
// first store. Values that have no zero (images, pointers) are left as they are.
Module withDefinedValues(const Module& module);

// Every arithmetic instruction on floats and every function of GLSL.std.450 decorated NoContraction: no fused, reassociated or distributed
// operations. (glslang does the same for `precise` values; drivers expand mix, for instance, by what stands around it.)
Module withoutContraction(const Module& module);

}  // namespace reprise
