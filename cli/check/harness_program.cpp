#include "cli/check/harness_program.h"

#include "compiler/source/harness_vertex.h"

namespace reprise {

Result<CompiledShader> harnessVertex(const CompiledShader& fragment) {
  REPRISE_ASSIGN(const std::string text, harnessVertexText(fragment.words));
  CompileOptions options;
  options.stage = ShaderStage::kVertex;
  return compileText(text, "harness.vert", options);
}

Result<ShaderProgram> harnessProgram(const CompiledShader& vertex, const CompiledShader& fragment) {
  ReflectOptions lenient;
  lenient.skip_unknown_members = lenient.any_arrays = lenient.any_bindings = true;
  return readProgram(vertex, fragment, lenient);
}

Result<ShaderProgram> harnessProgram(const CompiledShader& fragment) {
  REPRISE_ASSIGN(const CompiledShader vertex, harnessVertex(fragment));
  return harnessProgram(vertex, fragment);
}

}  // namespace reprise
