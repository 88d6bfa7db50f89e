// SPIRV-Tools passes through its public API. Only passes that leave every floating-point operation as it is (law 1):
// neither simplification nor constant propagation is among them, since both may reassociate or refold.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// Code that no output, storage write or discard of any entry point needs is removed, with unused globals.
Result<Module> removeDeadCode(const Module& module);

// Lines and sources removed, ids made dense: the form that ships. Names stay, for the readable GLSL and for debuggers.
Result<Module> stripForShipping(const Module& module);

// Loops whose loop control asks for it are unrolled, as far as their form allows.
Result<Module> unrollMarkedLoops(const Module& module);

}  // namespace reprise
