// Modules as values: reading and writing lose nothing, and damaged words are refused, never followed.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "compiler/ir/inline_calls.h"
#include "compiler/ir/module.h"
#include "compiler/ir/optimize.h"
#include "compiler/ir/promote_to_ssa.h"
#include "compiler/source/validate.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

class ShippedShader : public testing::TestWithParam<std::string> {};

TEST_P(ShippedShader, ReadingWhatWasWrittenGivesTheSameModule) {
  const std::vector<std::uint32_t> words = compile(GetParam(), {}).value().words;
  const Module module = readModule(words).value();
  const std::vector<std::uint32_t> written = writeModule(module);
  EXPECT_EQ(readModule(written).value(), module);
  const Result<void> valid = validateModule(written);
  EXPECT_TRUE(valid.ok()) << valid.error().message;
}

TEST_P(ShippedShader, KeepsTheLineOfEveryInstruction) {
  const Module module = readModule(compile(GetParam(), {}).value().words).value();
  for (const Function& function : module.functions)
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions)
        if (instruction.opcode == spv::Op::OpStore && instruction.line.line == 0) ADD_FAILURE() << "a store without a line";
}

TEST_P(ShippedShader, ReadsBackAfterEveryOptimization) {
  const Module module = readModule(compile(GetParam(), {}).value().words).value();
  for (const auto& pass : {inlineCalls, promoteToSsa, removeDeadCode, stripForShipping}) {
    const Module changed = pass(module).value();
    EXPECT_EQ(readModule(writeModule(changed)).value(), changed);
    EXPECT_TRUE(validateModule(writeModule(changed)).ok());
  }
}

INSTANTIATE_TEST_SUITE_P(Module, ShippedShader, testing::ValuesIn(shippedShaders()), [](const auto& parameter) {
  const std::filesystem::path file = parameter.param;
  return file.stem().string() + "_" + file.extension().string().substr(1);
});

std::vector<std::uint32_t> loopWords() {
  return compiled(
             "#version 450\n"
             "layout(location = 0) in vec2 p;\nlayout(location = 0) out vec4 color;\n"
             "void main() {\n  float sum = 0.0;\n"
             "  for (int i = 0; i < 4; ++i) { if (p.x > sum) discard; sum += sin(p.y); }\n"
             "  switch (int(sum)) { case 1: sum = 2.0; break; case 7: sum = 3.0; default: sum += 1.0; }\n"
             "  color = vec4(sum);\n}\n")
      .words;
}

RC_GTEST_PROP(Module, MutatedWordsAreRefusedOrRoundTrip, ()) {
  std::vector<std::uint32_t> words = loopWords();
  const int changes = *rc::gen::inRange(1, 4);
  for (int i = 0; i < changes; ++i) {
    const std::size_t at = *rc::gen::inRange<std::size_t>(0, words.size());
    words[at] = *rc::gen::oneOf(rc::gen::arbitrary<std::uint32_t>(), rc::gen::inRange<std::uint32_t>(0, 100),
                                rc::gen::just(words[at] ^ (1u << *rc::gen::inRange(0, 32))));
  }
  const Result<Module> module = readModule(words);
  if (!module.ok()) {
    RC_ASSERT(module.error().code == "spirv.invalid" || module.error().code == "spirv.limit");
    RC_ASSERT(!module.error().message.empty());
    return;
  }
  RC_ASSERT(readModule(writeModule(*module)).value() == *module);
}

RC_GTEST_PROP(Module, TruncatedWordsAreRefused, ()) {
  std::vector<std::uint32_t> words = loopWords();
  words.resize(*rc::gen::inRange<std::size_t>(0, words.size()));
  const Result<Module> module = readModule(words);
  if (module.ok()) RC_ASSERT(readModule(writeModule(*module)).value() == *module);
}

TEST(Module, AnIdBoundBeyondTheLimitIsRefused) {
  std::vector<std::uint32_t> words = loopWords();
  words[3] = kMostReadIds + 1;
  const Result<Module> module = readModule(words);
  ASSERT_FALSE(module.ok());
  EXPECT_EQ(module.error().code, "spirv.limit");
}

TEST(Module, StringOperandsKeepTheirText) {
  for (const char* text : {"", "abc", "abcd", "a longer name"}) EXPECT_EQ(stringOf(stringOperand(text)), text);
}

TEST(Module, NamesMembersAndDecorationsAreFound) {
  const Module module = moduleOf(
      "#version 450\nlayout(set = 1, binding = 3) uniform Scene { mat4 view; vec4 tint; } scene;\n"
      "layout(location = 0) out vec4 color;\nvoid main() { color = scene.tint; }\n");
  std::uint32_t scene = 0;
  for (const Instruction& global : module.globals)
    if (global.opcode == spv::Op::OpVariable && nameOf(module, global.result_id) == "scene") scene = global.result_id;
  ASSERT_NE(scene, 0u);
  EXPECT_EQ(decorationOf(module, scene, spv::Decoration::DescriptorSet), 1u);
  EXPECT_EQ(decorationOf(module, scene, spv::Decoration::Binding), 3u);
  EXPECT_EQ(decorationOf(module, scene, spv::Decoration::Location), std::nullopt);
  const std::uint32_t block = findGlobal(module, findGlobal(module, scene)->type_id)->word(1);
  EXPECT_EQ(nameOf(module, block), "Scene");
  EXPECT_EQ(memberNameOf(module, block, 1), "tint");
  EXPECT_EQ(memberDecorationOf(module, block, 1, spv::Decoration::Offset), 64u);
}

}  // namespace
}  // namespace reprise
