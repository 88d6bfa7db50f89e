// The members of a uniform, storage or push-constant block as interface.h describes them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/source/reflect.h"
#include "runtime/base/result.h"
#include "runtime/package/interface.h"

namespace spirv_cross {
class Compiler;
}

namespace reprise {

// Blocks with more flattened members than this (large arrays of structs) are refused.
inline constexpr std::size_t kMaxBlockMembers = 4096;

// Flattens the struct type `type_id`: "outer.inner" for structs, "lights[2].colour" for arrays of structs,
// and "grid[1]" with array_length for the outer dimensions of arrays of arrays. `block` names the block in
// messages. Error: source.unsupported for runtime-sized arrays and for members of 8, 16 or 64 bits.
Result<std::vector<BlockMember>> flattenBlock(const spirv_cross::Compiler& compiler, std::uint32_t type_id,
                                              const std::string& block, const ReflectOptions& options);

}  // namespace reprise
