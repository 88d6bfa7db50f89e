// The instructions of GLSL.std.450 by number; null for those of another file.
#pragma once

#include "cli/check/interpreter/machine.h"
#include "cli/check/interpreter/memory.h"

namespace reprise::interpreter {

inline constexpr std::size_t kFirstExtended = 2;  // operands 0 and 1 name the set and the instruction

Handler geometryHandler(std::uint32_t number);  // lengths, products, matrices, interpolation
Handler packingHandler(std::uint32_t number);

}  // namespace reprise::interpreter
