#include "compiler/strategies/shader_program.h"

#include "compiler/ir/optimize.h"
#include "compiler/source/interface_names.h"
#include "compiler/source/reflect.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {

Result<ShaderProgram> readProgram(const CompiledShader& vertex, const CompiledShader& fragment, const ReflectOptions& options) {
  ShaderProgram program;
  program.vertex_words = vertex.words;
  program.fragment_words = fragment.words;
  shareInterfaceNames(program.vertex_words, program.fragment_words);
  REPRISE_ASSIGN(program.interface, reflectInterface(program.vertex_words, program.fragment_words, options));
  REPRISE_ASSIGN(const Module vertex_module, readModule(program.vertex_words));
  REPRISE_ASSIGN(program.vertex, inlineCalls(vertex_module));
  REPRISE_ASSIGN(const Module fragment_module, readModule(program.fragment_words));
  REPRISE_ASSIGN(PreparedShader prepared, prepareForCaching(fragment_module, ""));
  program.fragment = std::make_shared<const PreparedShader>(std::move(prepared));
  program.analysis = analyse(*program.fragment);
  program.interface.discards = program.analysis.discards;
  program.sources = fragment.sources;
  program.hash = contentHash(std::string(bytesOf(vertex.words)) + std::string(bytesOf(fragment.words)));
  return program;
}

}  // namespace reprise
