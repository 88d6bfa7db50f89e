// Arithmetic on integer constants, and elements taken from constant composites, folded: both are exact on every device.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// Results of IAdd, ISub and IMul on 32-bit integer constants, CompositeExtract of constant composites and copies of constants become
// constants; access chains then have constant indices. Specialization constants stay open.
Module foldConstants(const Module& module);

}  // namespace reprise
