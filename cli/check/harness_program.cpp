#include "cli/check/harness_program.h"

#include "compiler/source/harness_vertex.h"

namespace reprise {

Result<ShaderProgram> harnessProgram(const CompiledShader& fragment) {
  ReflectOptions lenient;
  lenient.skip_unknown_members = lenient.any_arrays = lenient.any_bindings = true;
  REPRISE_ASSIGN(const std::string text, harnessVertexText(fragment.words));
  CompileOptions options;
  options.stage = ShaderStage::kVertex;
  REPRISE_ASSIGN(const CompiledShader vertex, compileText(text, "harness.vert", options));
  return readProgram(vertex, fragment, lenient);
}

}  // namespace reprise
