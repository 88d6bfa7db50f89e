// Values that say whether a function has returned.
//
// Inlining makes a variable of this name for each function that returns from a loop or a switch (single_return.h). What promotion makes of
// it says nothing of the shader's own and is no candidate.
#pragma once

#include <cstdint>
#include <unordered_set>

#include "compiler/ir/module.h"

namespace reprise {

inline constexpr const char* kReturnFlagName = "reprise.returned";

bool hasReturnFlags(const Module& module);

// In a module that had such flags: phis that join nothing but true, false and one another. A shader's own flags that are no more than
// that are among them, as unrolling keeps no names. Greatest fixed point.
std::unordered_set<std::uint32_t> flagsOfReturns(const Module& module, std::uint32_t function);

// Without names of that kind.
void dropReturnFlagNames(Module& module);

}  // namespace reprise
