// The source text that a module carries with it for debuggers, as glslangValidator -g, dxc -fspv-debug and slangc -g3 put it there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/source/compile.h"

namespace reprise {

// By file, in the module's order, lines as OpLine and DebugLine count them: what glslang writes before "#line 1" is left out. Those of OpSource and of
// DebugSource of NonSemantic.Shader.DebugInfo.100; none of files whose text is not there. The lengths of
// instructions must be sound, more need not be.
std::vector<SourceFile> embeddedSources(std::span<const std::uint32_t> words);

}  // namespace reprise
