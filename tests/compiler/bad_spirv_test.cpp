// SPIR-V binaries and assembler text: sound ones pass through, damaged ones are told apart and never crash.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "compiler/emit/emit.h"
#include "compiler/source/compile.h"
#include "compiler/source/reflect.h"
#include "compiler/source/validate.h"
#include "runtime/base/file.h"
#include "tests/compiler/scratch_directory.h"

namespace reprise {
namespace {

std::vector<std::uint32_t> discWords() {
  const Result<CompiledShader> shader = compileText(
      "#version 450\n"
      "layout(location = 0) in vec2 position;\n"
      "layout(location = 0) out vec4 color;\n"
      "float square(float x) { return x * x; }\n"
      "void main() {\n"
      "  if (square(position.x) > 1.0) discard;\n"
      "  color = vec4(square(position.y));\n"
      "}\n",
      "disc.frag", {});
  REPRISE_CHECK(shader.ok(), formatError(shader.error()));
  return shader->words;
}

Result<CompiledShader> compileWords(const std::vector<std::uint32_t>& words,
                                    const std::string& name = "disc.frag.spv") {
  return compileText(bytesOf(words), name, {});
}

TEST(SpirvInput, PassesThroughUnchangedWhateverTheFileIsCalled) {
  const std::vector<std::uint32_t> words = discWords();
  const ScratchDirectory scratch;
  for (const char* name : {"disc.spv", "disc.frag", "disc", "disc.vert"}) {
    const Result<CompiledShader> shader = compile(scratch.write(name, bytesOf(words)), {});
    ASSERT_TRUE(shader.ok()) << formatError(shader.error());
    EXPECT_EQ(shader->words, words);
    EXPECT_EQ(shader->stage, ShaderStage::kFragment);
    ASSERT_EQ(shader->sources.size(), 1u) << "the text that the module carries";
    EXPECT_EQ(shader->sources[0].path, "disc.frag");
    EXPECT_EQ(shader->sources[0].text.rfind("#version 450\n", 0), 0u) << shader->sources[0].text;
  }
}

TEST(SpirvInput, SwappedBytesAreBroughtToHostOrder) {
  const std::vector<std::uint32_t> words = discWords();
  std::string bytes(bytesOf(words));
  for (auto word = bytes.begin(); word != bytes.end(); word += 4) std::reverse(word, word + 4);
  const Result<CompiledShader> shader = compileText(bytes, "disc.spv", {});
  ASSERT_TRUE(shader.ok()) << formatError(shader.error());
  EXPECT_EQ(shader->words, words);
}

TEST(SpirvInput, IsRefusedTruncatedAtEveryWordAndByte) {
  const std::vector<std::uint32_t> words = discWords();
  const std::string bytes(bytesOf(words));
  for (std::size_t length = 1; length < words.size(); ++length) {
    const Result<CompiledShader> shader = compileText(bytes.substr(0, length * 4), "disc.spv", {});
    ASSERT_FALSE(shader.ok()) << length << " words";
    EXPECT_TRUE(shader.error().code == "source.truncated" || shader.error().code == "source.invalid")
        << length << ": " << formatError(shader.error());
    EXPECT_EQ(shader.error().place.file, "disc.spv");
  }
  for (std::size_t length : {std::size_t{5}, std::size_t{19}, std::size_t{22}, bytes.size() - 1}) {
    const Result<CompiledShader> shader = compileText(bytes.substr(0, length), "disc.spv", {});
    ASSERT_FALSE(shader.ok());
    EXPECT_EQ(shader.error().code, "source.truncated");
  }
}

TEST(SpirvInput, RefusesTextAndOtherBinariesCalledSpv) {
  for (const std::string& bytes :
       {std::string("void main() {}"), std::string("\x89PNG\r\n\x1a\n", 8), std::string("\x03")}) {
    const Result<CompiledShader> shader = compileText(bytes, "picture.spv", {});
    ASSERT_FALSE(shader.ok());
    EXPECT_EQ(shader.error().code, "source.not_spirv");
  }
}

TEST(SpirvInput, InvalidModulesCarryTheValidatorsMessage) {
  std::vector<std::uint32_t> words = discWords();
  words[3] = 2;  // an id bound that is too low
  const Result<CompiledShader> shader = compileWords(words);
  ASSERT_FALSE(shader.ok());
  EXPECT_EQ(shader.error().code, "source.invalid");
  EXPECT_NE(shader.error().message.find("bound"), std::string::npos) << shader.error().message;
}

TEST(SpirvInput, AMissingEntryPointListsThoseThatAreThere) {
  CompileOptions options;
  options.entry_point = "shade";
  const Result<CompiledShader> shader = compileText(bytesOf(discWords()), "disc.spv", options);
  ASSERT_FALSE(shader.ok());
  EXPECT_EQ(shader.error().code, "source.entry_point");
  EXPECT_NE(shader.error().message.find("\"main\" (fragment)"), std::string::npos) << shader.error().message;
}

constexpr const char* kTwoEntries = R"(
OpCapability Shader
OpMemoryModel Logical GLSL450
OpEntryPoint Fragment %first "first_of_two" %color
OpEntryPoint Fragment %second "second" %color
OpExecutionMode %first OriginUpperLeft
OpExecutionMode %second OriginUpperLeft
OpExecutionMode %second DepthReplacing
OpDecorate %color Location 0
%void = OpTypeVoid
%function = OpTypeFunction %void
%float = OpTypeFloat 32
%pointer = OpTypePointer Output %float
%color = OpVariable %pointer Output
%one = OpConstant %float 1
%first = OpFunction %void None %function
%label = OpLabel
OpStore %color %one
OpReturn
OpFunctionEnd
%second = OpFunction %void None %function
%other = OpLabel
OpReturn
OpFunctionEnd
)";

TEST(SpirvInput, KeepsTheWantedEntryPointAndCallsItMain) {
  CompileOptions options;
  for (const std::string name : {"first_of_two", "second"}) {
    options.entry_point = name;
    const Result<CompiledShader> shader = compileText(kTwoEntries, "two.frag.spvasm", options);
    ASSERT_TRUE(shader.ok()) << formatError(shader.error());
    EXPECT_TRUE(validateModule(shader->words).ok());
    const std::string text = disassemble(shader->words);
    EXPECT_NE(text.find("\"main\""), std::string::npos) << text;
    EXPECT_EQ(text.find("\"" + name), std::string::npos) << text;
    EXPECT_EQ(text.find("DepthReplacing") != std::string::npos, name == "second") << text;
  }
}

TEST(SpirvInput, TakesTheOnlyEntryPointOfTheStageWhateverItIsCalled) {
  std::string text = kTwoEntries;
  CompileOptions options;
  options.stage = ShaderStage::kFragment;
  EXPECT_EQ(compileText(text, "two.frag.spvasm", options).error().code, "source.entry_point");
  text.replace(text.find("OpEntryPoint Fragment %second \"second\" %color\n"), 46, "");
  text.replace(text.find("OpExecutionMode %second OriginUpperLeft\nOpExecutionMode %second DepthReplacing\n"), 79, "");
  const Result<CompiledShader> shader = compileText(text, "two.frag.spvasm", options);
  EXPECT_TRUE(shader.ok()) << formatError(shader.error());
}

TEST(SpirvInput, OtherStagesAreNamed) {
  const Result<std::vector<std::uint32_t>> words = assemble(
      "OpCapability Shader\nOpMemoryModel Logical GLSL450\nOpEntryPoint GLCompute %main \"main\"\n"
      "OpExecutionMode %main LocalSize 1 1 1\n%void = OpTypeVoid\n%function = OpTypeFunction %void\n"
      "%main = OpFunction %void None %function\n%label = OpLabel\nOpReturn\nOpFunctionEnd\n");
  ASSERT_TRUE(words.ok());
  const Result<CompiledShader> shader = compileWords(*words);
  ASSERT_FALSE(shader.ok());
  EXPECT_EQ(shader.error().code, "source.stage");
  EXPECT_NE(shader.error().message.find("compute"), std::string::npos) << shader.error().message;
}

// Opcode and length of every instruction: what is left of a module when ids are numbered anew.
std::vector<std::uint32_t> headsOf(const std::vector<std::uint32_t>& words) {
  std::vector<std::uint32_t> heads;
  for (std::size_t at = 5; at < words.size(); at += words[at] >> 16) heads.push_back(words[at]);
  return heads;
}

TEST(Assembly, RoundTripsAndCompiles) {
  const std::vector<std::uint32_t> words = discWords();
  const std::string text = disassemble(words);
  const Result<std::vector<std::uint32_t>> again = assemble(text);
  ASSERT_TRUE(again.ok()) << formatError(again.error());
  EXPECT_EQ(headsOf(*again), headsOf(words));
  const Result<std::vector<std::uint32_t>> third = assemble(disassemble(*again));
  ASSERT_TRUE(third.ok());
  EXPECT_EQ(headsOf(*third), headsOf(words));
  const Result<CompiledShader> shader = compileText(text, "disc.frag.spvasm", {});
  ASSERT_TRUE(shader.ok()) << formatError(shader.error());
  EXPECT_EQ(shader->stage, ShaderStage::kFragment);
}

TEST(Assembly, KeepsTheVersionOfTheHeader) {
  std::vector<std::uint32_t> words = discWords();
  for (std::uint32_t minor : {3u, 4u, 5u, 6u}) {
    words[1] = 0x00010000u | minor << 8;
    const Result<std::vector<std::uint32_t>> again = assemble(disassemble(words));
    ASSERT_TRUE(again.ok()) << formatError(again.error());
    EXPECT_EQ(again->at(1), words[1]);
  }
}

TEST(Assembly, ErrorsHavePlaces) {
  const Result<CompiledShader> shader = compileText("OpCapability Shader\n OpNonsense\n", "bad.spvasm", {});
  ASSERT_FALSE(shader.ok());
  EXPECT_EQ(shader.error().code, "source.invalid");
  EXPECT_EQ(shader.error().place, (Place{"bad.spvasm", 2, 2}));
}

// Whatever happens, each of the readers returns.
void readWithEverything(const std::vector<std::uint32_t>& words) {
  (void)validateModule(words);
  (void)disassemble(words);
  (void)readableGlsl(words);
  const Result<CompiledShader> shader = compileWords(words);
  if (!shader.ok()) {
    RC_ASSERT(!shader.error().message.empty());
    return;
  }
  (void)reflectInterface(shader->words, shader->words);
}

RC_GTEST_PROP(BadSpirv, RandomWordsNeverCrash, (std::vector<std::uint32_t> words)) {
  readWithEverything(words);
  words.insert(words.begin(), {0x07230203u, 0x00010300u, 0u, 100u, 0u});
  readWithEverything(words);
}

RC_GTEST_PROP(BadSpirv, DamagedModulesNeverCrash, ()) {
  std::vector<std::uint32_t> words = discWords();
  const int edits = *rc::gen::inRange(1, 5);
  for (int i = 0; i < edits; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(1, words.size());
    words[at] = *rc::gen::oneOf(rc::gen::inRange<std::uint32_t>(0, 64), rc::gen::arbitrary<std::uint32_t>(),
                                rc::gen::just(words[*rc::gen::inRange<std::size_t>(0, words.size())]));
  }
  readWithEverything(words);
}

// The assembler's own tokens in random order.
RC_GTEST_PROP(BadSpirv, RandomAssemblyNeverCrashes, ()) {
  const std::vector<std::string> tokens = {"%a", "=",           "OpLabel", "OpFunction", "OpTypeFloat",
                                           "32", "\"s",         "\\",      "\n",         "OpConstant",
                                           "!7", "0x1p-999999", "None",    ";",          "OpExtInst"};
  std::string text;
  for (const std::string& token : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(tokens))) {
    text += token + " ";
  }
  const Result<std::vector<std::uint32_t>> words = assemble(text);
  if (!words.ok()) RC_ASSERT(!words.error().message.empty());
}

}  // namespace
}  // namespace reprise
