// Sizes of what lies in blocks, by the layout that the module states.
#pragma once

#include <cstdint>

#include "compiler/ir/module.h"

namespace reprise {

// Bytes of a type; of a struct up to the end of its last member, rounded up to 16 bytes as std140 does. 0 of what has no size, such as
// images and arrays of unknown length.
std::uint32_t sizeOf(const Module& module, std::uint32_t type_id);

// Bytes of a struct's member: matrices are as large as the member's stride says.
std::uint32_t memberSize(const Module& module, std::uint32_t struct_id, std::uint32_t member);

}  // namespace reprise
