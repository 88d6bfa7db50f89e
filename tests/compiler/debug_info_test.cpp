// Modules with debug information of the NonSemantic kind, as glslangValidator -gVS makes them.
#include <gtest/gtest.h>

#include "compiler/ir/module.h"
#include "compiler/ir/prepare.h"
#include "compiler/source/debug_instructions.h"
#include "compiler/source/validate.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

const std::string kTraps = REPRISE_SOURCE_DIR "/tests/check/traps/";

class DebugInfo : public testing::TestWithParam<std::string> {};

TEST_P(DebugInfo, IsDroppedAndReadingIsTheInverseOfWriting) {
  const CompiledShader shader = compile(kTraps + GetParam(), {}).value();
  const Result<Module> module = readModule(shader.words);
  ASSERT_TRUE(module.ok()) << module.error().message;
  const std::vector<std::uint32_t> written = writeModule(*module);
  EXPECT_EQ(readModule(written).value(), *module);
  EXPECT_TRUE(validateModule(written).ok());
  for (const Instruction& import : module->imports) EXPECT_EQ(stringOf(import.operands[0]), "GLSL.std.450");
  for (const Instruction& extension : module->extensions) EXPECT_NE(stringOf(extension.operands[0]), "SPV_KHR_non_semantic_info");
  for (const Instruction& global : module->globals) EXPECT_NE(global.opcode, spv::Op::OpExtInst);
}

INSTANTIATE_TEST_SUITE_P(Module, DebugInfo, testing::Values("debug_info.spvasm", "debug_info_optimized.spvasm"),
                         [](const auto& test) { return test.param.substr(0, test.param.find('.')); });

TEST(DebugLines, BecomeThePlacesOfValues) {
  const CompiledShader shader = compile(kTraps + "debug_info.spvasm", {}).value();
  const PreparedShader prepared = prepareForCaching(readModule(shader.words).value(), "").value();
  const auto placeOfNamed = [&](const std::string& name) {
    for (const auto& [id, value] : prepared.named)
      if (value.name == name) return value.line;
    return LineMark{};
  };
  EXPECT_EQ(placeOfNamed("veins").line, 17u);
  EXPECT_EQ(placeOfNamed("lit").line, 28u);
  std::string file;
  for (const Instruction& source : prepared.module.debug_sources)
    if (source.result_id == placeOfNamed("lit").file) file = stringOf(source.operands[0]);
  EXPECT_EQ(file, "dbg.frag");
}

TEST(EmbeddedSources, ComeWithTheModule) {
  const CompiledShader shader = compile(kTraps + "debug_info.spvasm", {}).value();
  ASSERT_FALSE(shader.sources.empty());
  EXPECT_EQ(shader.sources[0].path, "dbg.frag");
  EXPECT_EQ(shader.sources[0].text.rfind("#version 450\n", 0), 0u) << shader.sources[0].text.substr(0, 60);
  const PreparedShader prepared = prepareForCaching(readModule(shader.words).value(), "").value();
  const ShaderAnalysis analysis = analyse(prepared);
  for (const Candidate& candidate : enumerateCandidates(prepared, analysis, shader.sources, {})) {
    if (candidate.name != "veins") continue;
    EXPECT_EQ(candidate.place.line, 17);
    EXPECT_EQ(candidate.place.column, 7);
    return;
  }
  FAIL() << "no value called veins";
}

TEST(DebugLines, EndAtDebugNoLine) {
  constexpr const char* kText =
      "OpCapability Shader\nOpExtension \"SPV_KHR_non_semantic_info\"\n%set = OpExtInstImport \"NonSemantic.Shader.DebugInfo.100\"\n"
      "OpMemoryModel Logical GLSL450\nOpEntryPoint Fragment %main \"main\"\nOpExecutionMode %main OriginUpperLeft\n"
      "%file = OpString \"a.frag\"\nOpName %source \"the source\"\n%void = OpTypeVoid\n%type = OpTypeFunction %void\n%uint = OpTypeInt 32 0\n"
      "%one = OpConstant %uint 1\n%seven = OpConstant %uint 7\n%source = OpExtInst %void %set DebugSource %file\n"
      "%main = OpFunction %void None %type\n%label = OpLabel\n%l = OpExtInst %void %set DebugLine %source %seven %seven %one %one\n"
      "%a = OpIAdd %uint %one %one\n%n = OpExtInst %void %set DebugNoLine\n%b = OpIAdd %uint %one %one\nOpReturn\n"
      "%after = OpExtInst %void %set DebugNoScope\nOpFunctionEnd\n";
  const Result<std::vector<std::uint32_t>> words = assemble(kText);
  ASSERT_TRUE(words.ok()) << words.error().message;
  const std::vector<std::uint32_t> bare = withoutDebugInstructions(*words);
  EXPECT_EQ(withoutDebugInstructions(bare), bare);
  EXPECT_TRUE(validateModule(bare).ok());
  const Result<Module> module = readModule(bare);
  ASSERT_TRUE(module.ok()) << module.error().message;
  const std::vector<Instruction>& code = module->functions.at(0).blocks.at(0).instructions;
  ASSERT_EQ(code.size(), 3u);
  EXPECT_EQ(code[0].line.line, 7u);
  EXPECT_EQ(code[0].line.column, 1u);
  EXPECT_EQ(code[1].line, LineMark{});
  EXPECT_EQ(code[2].opcode, spv::Op::OpReturn);
  EXPECT_TRUE(module->names.empty()) << "a name of what was dropped";
}

TEST(DebugInstructions, StayOutOfModulesWithoutThem) {
  const std::vector<std::uint32_t> words = compile(REPRISE_SOURCE_DIR "/shaders/marble/marble.frag", {}).value().words;
  EXPECT_EQ(withoutDebugInstructions(words), words);
}

}  // namespace
}  // namespace reprise
