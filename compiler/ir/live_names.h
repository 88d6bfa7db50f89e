// Names and decorations whose targets are gone.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// Removes them, as the validator takes a name of nothing for an id that is missing.
void dropNamesOfNothing(Module& module);

}  // namespace reprise
