// Instructions that say something to debuggers alone: those of the extended sets NonSemantic.*, OpenCL.DebugInfo.100 and DebugInfo, as
// glslangValidator -gVS and dxc -fspv-debug make them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace reprise {

// The module without them, their import, the extension SPV_KHR_non_semantic_info, and names and decorations of what is dropped. DebugLine and DebugNoLine of
// NonSemantic.Shader.DebugInfo.100 become OpLine and OpNoLine. The very words where there are none. The lengths of instructions must be sound,
// more need not be.
std::vector<std::uint32_t> withoutDebugInstructions(std::span<const std::uint32_t> words);

}  // namespace reprise
