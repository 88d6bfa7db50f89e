// Loops: written out where they are short, and what they leave behind as a value.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/ir/fold_constants.h"
#include "compiler/ir/globals.h"
#include "compiler/source/validate.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

constexpr std::uint32_t kSin = 13;

std::string shaderOf(const std::string& body) {
  return "#version 450\nlayout(location = 0) in vec4 p;\nlayout(set = 0, binding = 0) uniform Scene { int count; vec4 tint; } scene;\n"
         "layout(location = 0) out vec4 color;\nvoid main() {\n" + body + "\n}\n";
}

const Function& entryOf(const AnalysedShader& shader) { return *findFunction(shader.shader.module, shader.shader.entry_function); }

TEST(Unroll, AShortLoopBecomesItsIterations) {
  const auto shader = analysedWhole(shaderOf("float sum = 0.0;\nfor (int i = 0; i < 5; ++i)\n  sum += sin(p.x * float(i) + 0.1);\ncolor = vec4(sum);"));
  EXPECT_EQ(countOf(entryOf(*shader), spv::Op::OpLoopMerge), 0);
  EXPECT_EQ(countOfExtended(entryOf(*shader), kSin), 5);
  EXPECT_TRUE(validateModule(writeModule(shader->shader.module)).ok());
}

TEST(LoopResult, HasItsNameWhereOtherVariablesBeginWithTheSameConstant) {
  const auto shader = analysedWhole(R"(#version 450
layout(location = 0) in vec3 p;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Scene { int turns; float shift; };
float wave(float x) {
  float sum = 0.0;
  for (int i = 0; i < turns; ++i) sum += sin(x * float(i));
  return sum;
}
void main() {
  float standing = 0.0;
  for (int i = 0; i < turns; ++i) standing += wave(p.x + float(i));
  float moving = wave(p.y + shift);
  color = vec4(exp(standing + moving) * p.z);
}
)");
  const auto isStanding = [](const Candidate& candidate) { return candidate.name == "standing" && candidate.kept(); };
  EXPECT_TRUE(std::any_of(shader->candidates.begin(), shader->candidates.end(), isStanding));
}

TEST(Unroll, IterationsKeepTheNamesOfTheirValues) {
  const auto shader = analysedWhole(shaderOf("float sum = 0.0;\nfor (int i = 0; i < 5; ++i)\n  sum += sin(p.x * float(i) + 0.1);\ncolor = sum * p;"));
  int named = 0;
  for (const Candidate& candidate : shader->candidates) named += candidate.name == "sum";
  EXPECT_EQ(named, 5);
}

TEST(Unroll, NestedShortLoopsToo) {
  const auto shader = analysedWhole(shaderOf("float sum = 0.0;\nfor (int i = 0; i < 3; ++i)\n  for (int j = 0; j < 3; ++j)\n"
                                             "    sum += sin(p.x * float(i) + p.y * float(j));\ncolor = vec4(sum);"));
  EXPECT_EQ(countOf(entryOf(*shader), spv::Op::OpLoopMerge), 0);
  EXPECT_EQ(countOfExtended(entryOf(*shader), kSin), 9);
}

TEST(Unroll, AWeightTableBecomesConstants) {
  const auto shader = analysedWhole(shaderOf("const float weight[3] = float[](0.25, 0.5, 0.25);\nfloat sum = 0.0;\n"
                                             "for (int i = 0; i < 3; ++i)\n  sum += weight[i] * sin(p.x + float(i));\ncolor = vec4(sum);"));
  EXPECT_EQ(countOf(entryOf(*shader), spv::Op::OpVariable), 0);
  EXPECT_EQ(countOf(entryOf(*shader), spv::Op::OpLoad), 3) << "of the varying, one for each iteration";
}

TEST(Unroll, LongAndOpenLoopsStay) {
  for (const char* bound : {"40", "scene.count"}) {
    const auto shader = analysedWhole(shaderOf(std::string("float sum = 0.0;\nfor (int i = 0; i < ") + bound +
                                               "; ++i)\n  sum += sin(p.x * float(i) + sum);\ncolor = vec4(sum);"));
    EXPECT_EQ(countOf(entryOf(*shader), spv::Op::OpLoopMerge), 1) << bound;
  }
}

TEST(Unroll, ALoopAboveTheLimitOnlyWhereItsAuthorAsks) {
  const std::string loops = "for (int i = 0; i < 30; ++i)\n  for (int j = 0; j < 5; ++j)\n    sum += sin(p.x * float(i) + p.y * float(j));\n";
  const auto asked = analysedWhole("#version 450\n#extension GL_EXT_control_flow_attributes : require\nlayout(location = 0) in vec4 p;\n"
                                   "layout(location = 0) out vec4 color;\nvoid main() {\nfloat sum = 0.0;\n[[unroll]] " + loops + "color = vec4(sum);\n}\n");
  EXPECT_EQ(countOf(entryOf(*asked), spv::Op::OpLoopMerge), 0);
  const auto silent = analysedWhole(shaderOf("float sum = 0.0;\n" + loops + "color = vec4(sum);"));
  EXPECT_GT(countOf(entryOf(*silent), spv::Op::OpLoopMerge), 0);
}

TEST(LoopResults, WhatALoopLeavesBehindIsACandidate) {
  const auto shader = analysedWhole(shaderOf("float sum = 0.0;\nfor (int i = 0; i < scene.count; ++i)\n  sum += sin(p.x * float(i) + sum);\n"
                                             "color = sum * exp(p);"));
  EXPECT_TRUE(validateModule(writeModule(shader->shader.module)).ok());
  const Candidate* result = nullptr;
  for (const Candidate& candidate : shader->candidates)
    if (candidate.kept() && candidate.name == "sum" && candidate.values.size() == 1) result = &candidate;
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->operation, "Phi");
  EXPECT_GT(result->share, 0.5);
}

TEST(LoopResults, AValueThatLeavesTwoLoopsIsOneAfterEach) {
  const auto shader = analysedWhole(shaderOf("float last = 0.0;\nfor (int i = 0; i < scene.count; ++i) {\n  float sum = last;\n"
                                             "  for (int j = 0; j < scene.count; ++j) sum += sin(p.x * float(j) + sum);\n"
                                             "  last = sum * 0.5;\n}\ncolor = last * exp(p);"));
  EXPECT_TRUE(validateModule(writeModule(shader->shader.module)).ok());
  bool kept = false;
  for (const Candidate& candidate : shader->candidates) kept |= candidate.kept() && candidate.operation == "Phi";
  EXPECT_TRUE(kept);
}

TEST(LoopResults, BreaksThatGoThroughOtherBlocksStayValid) {
  const auto shader = analysedWhole(shaderOf("float sum = 0.0;\nfor (int i = 0; i < scene.count; ++i) {\n  sum += sin(p.x * float(i) + sum);\n"
                                             "  if (sum > 2.0) { sum *= 0.5; break; }\n}\ncolor = sum * exp(p);"));
  const Result<void> valid = validateModule(writeModule(shader->shader.module));
  EXPECT_TRUE(valid.ok()) << valid.error().message;
}

TEST(Fold, FloatsAndSpecializationConstantsStayAsTheyAre) {
  Module module = moduleOf(shaderOf("color = vec4(p.x);"));
  const std::uint32_t two = uintConstant(module, 2), type = uintType(module), open = module.freshId(), sum = module.freshId(), more = module.freshId();
  module.globals.push_back(makeInstruction(spv::Op::OpSpecConstant, type, open, {literalOperand(3)}));
  auto& code = module.functions.front().blocks.front().instructions;
  code.insert(code.begin(), {makeInstruction(spv::Op::OpIAdd, type, sum, {idOperand(two), idOperand(two)}),
                             makeInstruction(spv::Op::OpIAdd, type, more, {idOperand(sum), idOperand(open)})});
  const Module folded = foldConstants(module);
  const auto& after = folded.functions.front().blocks.front().instructions;
  const Instruction& last = after[1];
  ASSERT_EQ(last.result_id, more);
  EXPECT_EQ(findGlobal(folded, last.word(0))->word(0), 4u);
  EXPECT_EQ(last.word(1), open);
}

}  // namespace
}  // namespace reprise
