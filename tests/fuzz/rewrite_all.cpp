#include "tests/fuzz/rewrite_all.h"

#include "compiler/emit/emit.h"
#include "compiler/source/compile.h"
#include "compiler/source/harness_vertex.h"
#include "compiler/strategies/build_package.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

constexpr const char* kPlainFragment = R"(#version 450
layout(location = 0) out vec4 color;
void main() {
  float wave = sin(gl_FragCoord.x) * cos(gl_FragCoord.y);
  color = vec4(exp(wave), wave, 0.0, 1.0);
}
)";

Result<ShaderProgram> programOf(std::span<const std::uint32_t> words) {
  REPRISE_ASSIGN(const CompiledShader given, compileText(bytesOf(words), "given.spv", {}));
  ReflectOptions lenient;
  lenient.skip_unknown_members = true;
  CompileOptions options;
  if (given.stage == ShaderStage::kVertex) {
    options.stage = ShaderStage::kFragment;
    REPRISE_ASSIGN(const CompiledShader fragment, compileText(kPlainFragment, "plain.frag", options));
    return readProgram(given, fragment, lenient);
  }
  REPRISE_ASSIGN(const std::string text, harnessVertexText(given.words));
  options.stage = ShaderStage::kVertex;
  REPRISE_ASSIGN(const CompiledShader vertex, compileText(text, "harness.vert", options));
  return readProgram(vertex, given, lenient);
}

VariantOptions optionsOf(const Strategy& strategy, const Candidate& candidate, std::uint32_t choices) {
  VariantOptions options;
  options.strategy = strategy.name;
  options.pattern = static_cast<PatternKind>(choices % 3);
  options.encoding = static_cast<Encoding>(choices / 4 % 4);
  options.filter = (choices & 16) != 0 || isInteger(candidate.scalar) ? Filter::kNearest : Filter::kBilinear;
  options.instrumented = (choices & 32) != 0;
  options.orthographic = (choices & 64) != 0;
  return options;
}

}  // namespace

Result<void> rewriteAll(std::span<const std::uint32_t> words, const Rewriting& rewriting) {
  REPRISE_ASSIGN(const ShaderProgram program, programOf(words));
  CandidateOptions enumeration;
  enumeration.least_share = 0;
  enumeration.most = rewriting.candidates;
  const std::vector<Candidate> candidates =
      enumerateCandidates(*program.fragment, program.analysis, program.sources, enumeration);
  const StateLimits limits{true, true, true};
  for (const Candidate& candidate : candidates) {
    if (!candidate.kept()) break;
    for (const Strategy& strategy : strategies()) {
      if (!strategy.selectable) continue;
      const Result<Package> package =
          buildPackage(program, candidate, optionsOf(strategy, candidate, rewriting.choices), limits);
      if (!package.ok()) {
        REPRISE_CHECK(package.error().code != "rewrite.invalid", strategy.name, candidate.id, package.error().message);
        REPRISE_CHECK(!package.error().code.empty() && !package.error().message.empty(), strategy.name, candidate.id);
        continue;
      }
      const Result<void> checked = checkPackage(*package);
      REPRISE_CHECK(checked.ok(), strategy.name, candidate.id, checked.error().message);
    }
  }
  return {};
}

}  // namespace reprise
