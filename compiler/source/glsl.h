// GLSL and HLSL (.hlsl) to SPIR-V through glslang.
#pragma once

#include <string>
#include <string_view>

#include "compiler/source/compile.h"

namespace reprise {

// `name` stands for the file in messages and in debug information. Errors: source.syntax, source.include,
// source.standard, source.define (kUsage; the name of a -D is no identifier). The result has not been
// validated.
Result<CompiledShader> translateGlsl(std::string_view text, const std::string& name, ShaderStage stage,
                                     const CompileOptions& options);

}  // namespace reprise
