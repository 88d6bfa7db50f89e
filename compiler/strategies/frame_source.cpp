#include "compiler/strategies/frame_source.h"

#include "compiler/strategies/embedded_glsl.h"

namespace reprise {
namespace {

const char* embedded(const std::string& name) {
  for (const EmbeddedGlsl& file : kEmbeddedGlsl)
    if (name == file.name) return file.text;
  REPRISE_CHECK(false, name);
  return nullptr;
}

// Every frame file is included once and from the top level only, so one level of expansion is enough.
std::string expand(const std::string& name) {
  const std::string text = embedded(name);
  const std::string directive = "#include \"";
  std::string expanded;
  std::size_t from = 0;
  for (std::size_t at = text.find(directive); at != std::string::npos; at = text.find(directive, from)) {
    expanded += text.substr(from, at - from);
    const std::size_t start = at + directive.size();
    const std::size_t end = text.find('"', start);
    expanded += embedded(text.substr(start, end - start));
    from = end + 1;
  }
  return expanded + text.substr(from);
}

}  // namespace

Module compileFrame(const std::string& name, ShaderStage stage, const std::map<std::string, std::string>& macros) {
  std::string text = "#version 450\n";
  for (const auto& [macro, value] : macros) text += "#define " + macro + " " + value + "\n";
  text += expand(name);
  CompileOptions options;
  options.stage = stage;
  const Result<CompiledShader> compiled = compileText(text, name, options);
  REPRISE_CHECK(compiled.ok(), compiled.ok() ? "" : formatError(compiled.error()));
  const Result<Module> module = readModule(compiled->words);
  REPRISE_CHECK(module.ok(), name);
  return *module;
}

}  // namespace reprise
