// SPIR-V binaries as users give them: told from other bytes, brought to host order, checked, their stage
// found.
#pragma once

#include <string>
#include <string_view>

#include "compiler/source/compile.h"

namespace reprise {

// True for bytes that begin with the magic number of SPIR-V in either byte order.
bool looksLikeSpirv(std::string_view bytes);

// Errors: source.truncated, source.invalid, source.entry_point, source.stage; all placed in the file `name`.
Result<CompiledShader> readSpirv(std::string_view bytes, const std::string& name,
                                 const CompileOptions& options);

}  // namespace reprise
