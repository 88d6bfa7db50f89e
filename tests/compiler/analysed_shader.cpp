#include "tests/compiler/analysed_shader.h"

#include <algorithm>
#include <filesystem>

#include "compiler/source/standard_vertex.h"

namespace reprise {

CompiledShader compiled(std::string_view text, const std::string& name) {
  Result<CompiledShader> shader = compileText(text, name, {});
  REPRISE_CHECK(shader.ok(), formatError(shader.error()));
  return std::move(shader).value();
}

Module moduleOf(std::string_view text, const std::string& name) {
  return readModule(compiled(text, name).words).value();
}

const Candidate& AnalysedShader::named(const std::string& name) const {
  const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& one) { return one.name == name; });
  REPRISE_CHECK(found != candidates.end(), "no value is called " + name);
  return *found;
}

std::vector<std::string> AnalysedShader::inputsOf(const std::string& name) const {
  std::vector<std::string> names = inputNames(named(name), analysis);
  std::sort(names.begin(), names.end());
  return names;
}

std::unique_ptr<AnalysedShader> analysed(std::string_view text, const CandidateOptions& options) {
  auto result = std::make_unique<AnalysedShader>();
  CompiledShader shader = compiled(text);
  result->sources = std::move(shader.sources);
  result->shader = prepareForCaching(readModule(shader.words).value(), "main").value();
  result->analysis = analyse(result->shader);
  result->candidates = enumerateCandidates(result->shader, result->analysis, result->sources, options);
  return result;
}

std::unique_ptr<AnalysedShader> analysedWhole(std::string_view text) {
  CandidateOptions options;
  options.least_share = 0;
  options.most = 1000;
  return analysed(text, options);
}

namespace {

std::vector<std::string> shadersWithEnding(const std::vector<std::string>& endings) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(REPRISE_SOURCE_DIR) + "/shaders"))
    if (std::find(endings.begin(), endings.end(), entry.path().extension().string()) != endings.end())
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::string> shippedShaders() { return shadersWithEnding({".vert", ".frag"}); }
std::vector<std::string> shippedFragmentShaders() { return shadersWithEnding({".frag"}); }

ShaderProgram shippedProgram(const std::string& fragment_file) {
  const CompiledShader fragment = compile(fragment_file, {}).value();
  if (std::filesystem::path(fragment_file).parent_path().filename() == "standard") {
    CompileOptions options;
    options.stage = ShaderStage::kVertex;
    return readProgram(compileText(standardVertexText(fragment.words, {}).value(), "standard.vert", options).value(), fragment).value();
  }
  std::filesystem::path vertex_file = std::filesystem::path(fragment_file).replace_extension(".vert");
  if (!std::filesystem::exists(vertex_file)) vertex_file = std::string(REPRISE_SOURCE_DIR) + "/shaders/laws/law.vert";
  return readProgram(compile(vertex_file, {}).value(), fragment).value();
}

std::string stemOf(const std::string& file) { return std::filesystem::path(file).stem().string(); }

int countOf(const Function& function, spv::Op opcode) {
  int count = 0;
  for (const Block& block : function.blocks)
    for (const Instruction& instruction : block.instructions) count += instruction.opcode == opcode;
  return count;
}

int countOfExtended(const Function& function, std::uint32_t number) {
  int count = 0;
  for (const Block& block : function.blocks)
    for (const Instruction& instruction : block.instructions)
      count += instruction.opcode == spv::Op::OpExtInst && instruction.word(1) == number;
  return count;
}

}  // namespace reprise
