// A fragment shader with the vertex shader that the harness makes up for it.
#pragma once

#include "compiler/strategies/shader_program.h"

namespace reprise {

// Errors: those of harnessVertexText and compileText.
Result<CompiledShader> harnessVertex(const CompiledShader& fragment);

// Lenient in what the interface holds: the harness makes up contents for what scenarios cannot give. Errors: those of readProgram.
Result<ShaderProgram> harnessProgram(const CompiledShader& vertex, const CompiledShader& fragment);
// With its harnessVertex.
Result<ShaderProgram> harnessProgram(const CompiledShader& fragment);

}  // namespace reprise
