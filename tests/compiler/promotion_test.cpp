// Inlining and promotion to SSA: text in, the shape of the values out. That both compute what the module as given does is held by the
// interpreter, over random shaders, in tests/fuzz/structured_shaders_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/ir/inline_calls.h"
#include "compiler/ir/promote_to_ssa.h"
#include "compiler/ir/return_flags.h"
#include "compiler/source/validate.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

using spv::Op;

const std::string kHead = "#version 450\nlayout(location = 0) in vec4 p;\nlayout(location = 1) flat in int n;\nlayout(location = 0) out vec4 color;\n";

Module promotedOf(const Module& given) {
  Module promoted = promoteToSsa(inlineCalls(given).value()).value();
  const Result<void> valid = validateModule(writeModule(promoted));
  EXPECT_TRUE(valid.ok()) << valid.error().message;
  return promoted;
}

Module promoted(const std::string& text) { return promotedOf(moduleOf(kHead + text)); }

Module promotedAssembly(const std::string& text) { return promotedOf(readModule(assemble(text).value()).value()); }

const Function& entryOf(const Module& module) { return *findFunction(module, module.entry_points.front().word(1)); }

int countIn(const Module& module, Op opcode) { return countOf(entryOf(module), opcode); }

std::vector<std::string> phiNames(const Module& module) {
  std::vector<std::string> names;
  for (const Block& block : entryOf(module).blocks)
    for (const Instruction& instruction : block.instructions)
      if (instruction.opcode == Op::OpPhi) names.push_back(nameOf(module, instruction.result_id));
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Promotion, LeavesNoVariableOfScalarsVectorsMatricesStructsAndArrays) {
  const Module module = promoted(R"(struct Lamp { vec3 place; float weight[3]; };
void main() {
  Lamp lamp = Lamp(p.xyz, float[](0.1, 0.2, p.w));
  Lamp other = lamp;
  mat3 turn = mat3(1.0);
  turn[1].y = p.x;
  turn[2] = other.place;
  other.weight[1] += lamp.weight[2];
  vec4 sum = vec4(turn * lamp.place, other.weight[1]);
  sum.zx = sum.xy;
  color = sum;
})");
  EXPECT_EQ(countIn(module, Op::OpVariable), 0);
  EXPECT_EQ(countIn(module, Op::OpLoad), 3) << "of p alone: p.xyz, p.w, p.x";
}

TEST(Promotion, AnArrayThatIsIndexedDynamicallyStaysAndTheStructAroundItDoesNot) {
  const Module module = promoted(R"(struct Lamp { vec3 place; float weight[3]; };
void main() {
  Lamp lamp = Lamp(p.xyz, float[](0.1, 0.2, 0.3));
  lamp.weight[n] = p.y;
  color = vec4(lamp.place, lamp.weight[(n + 1) % 3]);
})");
  ASSERT_EQ(countIn(module, Op::OpVariable), 1);
  EXPECT_EQ(countIn(module, Op::OpAccessChain), 2 + 1) << "the two dynamic ones, and that of p.y";
}

TEST(Promotion, AComponentAtADynamicIndexIsAnInsertionAndAnExtraction) {
  const Module module = promoted("void main() {\n  vec4 v = p;\n  v[n] = 0.5;\n  color = vec4(v[n + 1]) + v;\n}");
  EXPECT_EQ(countIn(module, Op::OpVariable), 0);
  EXPECT_EQ(countIn(module, Op::OpVectorInsertDynamic), 1);
  EXPECT_EQ(countIn(module, Op::OpVectorExtractDynamic), 1);
}

TEST(Promotion, PhisHaveTheNamesOfTheirVariablesAndStandOnlyWhereTheyAreRead) {
  const Module module = promoted(R"(void main() {
  float sum = 0.0, unread = 1.0;
  for (int i = 0; i < n; ++i) { if (p.x > float(i)) sum += p.y; unread = sum; }
  color = vec4(sum);
})");
  EXPECT_EQ(phiNames(module), (std::vector<std::string>{"i", "sum", "sum"}));
}

TEST(Promotion, AVariableThatIsReadBeforeItIsStoredIsUndefinedThere) {
  const Module module = promoted("void main() {\n  float late;\n  if (p.x > 0.0) late = p.y;\n  color = vec4(late);\n}");
  EXPECT_EQ(phiNames(module), std::vector<std::string>{"late"});
  EXPECT_TRUE(std::any_of(module.globals.begin(), module.globals.end(), [](const Instruction& one) { return one.opcode == Op::OpUndef; }));
}

TEST(Promotion, PrivateVariablesBeginWithTheirInitializers) {
  const Module module = promoted("float gain = 2.0;\nvoid grow() { gain *= p.x; }\nvoid main() {\n  grow();\n  grow();\n  color = vec4(gain);\n}");
  EXPECT_EQ(countIn(module, Op::OpVariable), 0);
  EXPECT_EQ(countIn(module, Op::OpFMul), 2);
  for (const Instruction& global : module.globals)
    EXPECT_FALSE(global.opcode == Op::OpVariable && static_cast<spv::StorageClass>(global.word(0)) == spv::StorageClass::Private);
}

TEST(Promotion, RelaxedPrecisionOfAVariableIsThatOfItsPhi) {
  const Module module = promoted("void main() {\n  mediump float soft = p.x;\n  if (p.y > 0.0) soft = p.z;\n  color = vec4(soft);\n}");
  for (const Block& block : entryOf(module).blocks)
    for (const Instruction& instruction : block.instructions)
      if (instruction.opcode == Op::OpPhi) {
        EXPECT_TRUE(decorationOf(module, instruction.result_id, spv::Decoration::RelaxedPrecision));
      }
}

// A fragment module around the code of main; %p is a float, %out the output, %float_ptr a pointer to a local.
std::string assemblyOf(const std::string& code) {
  return R"(OpCapability Shader
OpMemoryModel Logical GLSL450
OpEntryPoint Fragment %main "main" %in %out
OpExecutionMode %main OriginUpperLeft
OpDecorate %in Location 0
OpDecorate %out Location 0
%void = OpTypeVoid
%fn = OpTypeFunction %void
%float = OpTypeFloat 32
%bool = OpTypeBool
%int = OpTypeInt 32 1
%in_ptr = OpTypePointer Input %float
%out_ptr = OpTypePointer Output %float
%float_ptr = OpTypePointer Function %float
%in = OpVariable %in_ptr Input
%out = OpVariable %out_ptr Output
%zero = OpConstant %float 0
%one = OpConstant %float 1
%two = OpConstant %float 2
%int_0 = OpConstant %int 0
%fn_float = OpTypeFunction %float
%main = OpFunction %void None %fn
%entry = OpLabel
)" + code + "OpFunctionEnd\n";
}

TEST(Promotion, VolatileAccessesStay) {
  const Module module = promotedAssembly(assemblyOf(R"(%v = OpVariable %float_ptr Function %one
OpStore %v %two Volatile
%x = OpLoad %float %v
OpStore %out %x
OpReturn
)"));
  EXPECT_EQ(countIn(module, Op::OpVariable), 1);
  EXPECT_EQ(countIn(module, Op::OpStore), 2);
}

TEST(Promotion, AnInitializerOfALocalIsItsFirstValue) {
  const Module module = promotedAssembly(assemblyOf(R"(%v = OpVariable %float_ptr Function %two
%x = OpLoad %float %v
OpStore %out %x
OpReturn
)"));
  EXPECT_EQ(countIn(module, Op::OpVariable), 0);
  const Instruction& store = entryOf(module).blocks[0].instructions[0];
  ASSERT_EQ(store.opcode, Op::OpStore);
  EXPECT_EQ(findGlobal(module, store.word(1))->word(0), 0x40000000u);
}

TEST(Promotion, BlocksThatKillAndThatNothingReachesAreTaken) {
  const Module module = promotedAssembly(assemblyOf(R"(%v = OpVariable %float_ptr Function
%a = OpLoad %float %in
%c = OpFOrdLessThan %bool %a %zero
OpStore %v %one
OpSelectionMerge %merge None
OpSwitch %int_0 %merge 1 %less 2 %more
%less = OpLabel
OpKill
%more = OpLabel
OpStore %v %a
OpSelectionMerge %never None
OpBranchConditional %c %left %right
%left = OpLabel
OpStore %out %a
OpReturn
%right = OpLabel
OpReturn
%never = OpLabel
%n = OpLoad %float %v
OpStore %out %n
OpBranch %merge
%merge = OpLabel
%x = OpLoad %float %v
OpStore %out %x
OpReturn
)"));
  EXPECT_EQ(countIn(module, Op::OpVariable), 0);
  EXPECT_EQ(entryOf(module).blocks.size(), 7u) << "a merge block has to stay";
  EXPECT_EQ(countIn(module, Op::OpPhi), 0) << "of the ways into the merge block one is run and one is not";
}

TEST(Inlining, AnEarlyReturnIsASwitchOfOneCase) {
  const Module module = promoted("float f(float x) { if (x > 0.5) return x; return x * 2.0; }\nvoid main() { color = vec4(f(p.x)); }");
  EXPECT_EQ(module.functions.size(), 1u);
  EXPECT_EQ(countIn(module, Op::OpFunctionCall), 0);
  EXPECT_EQ(countIn(module, Op::OpSwitch), 1);
  EXPECT_EQ(countIn(module, Op::OpPhi), 1) << "the value that was returned";
}

TEST(Inlining, AFunctionWithOneReturnAddsNoBlocks) {
  const Module module = promoted("float f(float x) { return x * 2.0; }\nvoid main() { color = vec4(f(p.x) + f(p.y)); }");
  EXPECT_EQ(entryOf(module).blocks.size(), 1u);
}

TEST(Inlining, AReturnFromNestedLoopsIsTestedAfterEachOfThem) {
  const std::string text = R"(float f(float x) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      switch (j & 3) { case 0: if (x > float(i * j)) return x; break; default: x += 0.5; }
    }
  return -x;
}
void main() { color = vec4(f(p.x)); })";
  const Module module = promoted(text);
  EXPECT_EQ(countIn(module, Op::OpVariable), 0);
  EXPECT_EQ(countIn(module, Op::OpLoopMerge), 2);
  const auto flags = flagsOfReturns(module, entryOf(module).id());
  EXPECT_GE(flags.size(), 3u) << "one behind the switch and behind each loop";
  const auto shader = analysedWhole(kHead + text);
  EXPECT_FALSE(shader->shader.return_flags.empty());
  for (const Candidate& candidate : shader->candidates)
    if (shader->shader.return_flags.count(candidate.values.front().value) != 0) {
      EXPECT_FALSE(candidate.kept()) << candidate.id;
    }
}

TEST(Inlining, CallsInConditionsOfLoopsAndInLoopsOfOneBlock) {
  const Module module = promoted(R"(bool far(float x) { if (x > 4.0) return true; return x < -4.0; }
void main() {
  float x = p.x;
  do { x *= 1.5; } while (!far(x));
  while (far(x)) x *= 0.5;
  for (int i = 0; far(x + float(i)) || i < 3; ++i) x += 0.25;
  color = vec4(x);
})");
  EXPECT_EQ(countIn(module, Op::OpFunctionCall), 0);
  EXPECT_EQ(countIn(module, Op::OpLoopMerge), 3);
}

// Of the two branches that both leave the loop, the merge block is never run; in a continue construct it must not end the function.
TEST(Inlining, WhatIsNeverRunLeavesAContinueConstructByItsBackEdge) {
  const Module module = promoted(R"(bool far(float x) {
  do {
    if (x > p.y) { } else { if (x > 1.0) return true; else break; }
    x *= 2.0;
  } while (x < 9.0);
  return x > 4.0;
}
void main() {
  float x = p.x;
  int i = 0;
  do { x += 0.5; } while (i++ < n && far(x));
  color = vec4(x);
})");
  EXPECT_EQ(countIn(module, Op::OpFunctionCall), 0);
}

TEST(Inlining, AFunctionThatNeverReturnsEndsItsCaller) {
  const Module module = promoted("float gone() { discard; return 1.0; }\nvoid main() {\n  float x = 1.0;\n  if (p.x > 0.5) x = gone();\n  color = vec4(x);\n}");
  EXPECT_EQ(countIn(module, Op::OpKill), 1);
  EXPECT_EQ(countIn(module, Op::OpPhi), 0);
}

TEST(Inlining, LocalsOfACalleeBeginAnewAtEachCall) {
  const std::string callee = R"(%f = OpFunction %float None %fn_float
%f_entry = OpLabel
%local = OpVariable %float_ptr Function %one
%before = OpLoad %float %local
%after = OpFAdd %float %before %two
OpStore %local %after
OpReturnValue %after
OpFunctionEnd
)";
  const std::string main = assemblyOf("%a = OpFunctionCall %float %f\n%b = OpFunctionCall %float %f\n%s = OpFAdd %float %a %b\nOpStore %out %s\nOpReturn\n");
  const Module module = promotedAssembly(main + callee);
  EXPECT_EQ(countIn(module, Op::OpVariable), 0);
  int from_one = 0;
  for (const Instruction& instruction : entryOf(module).blocks[0].instructions)
    if (instruction.opcode == Op::OpFAdd) {
      const Instruction* first = findGlobal(module, instruction.word(0));
      from_one += first != nullptr && first->opcode == Op::OpConstant && first->word(0) == 0x3f800000u;
    }
  EXPECT_EQ(from_one, 2);
}

TEST(Inlining, ADiscardDoesNotGoIntoAContinueConstruct) {
  const std::string callee = R"(%f = OpFunction %float None %fn_float
%f_entry = OpLabel
%x = OpLoad %float %in
%c = OpFOrdLessThan %bool %x %zero
OpSelectionMerge %f_merge None
OpBranchConditional %c %kill %f_merge
%kill = OpLabel
OpKill
%f_merge = OpLabel
OpReturnValue %x
OpFunctionEnd
)";
  const std::string main = assemblyOf(R"(OpBranch %head
%head = OpLabel
%sum = OpPhi %float %zero %entry %more %next
%less = OpFOrdLessThan %bool %sum %two
OpLoopMerge %merge %next None
OpBranchConditional %less %body %merge
%body = OpLabel
OpBranch %next
%next = OpLabel
%step = OpFunctionCall %float %f
%more = OpFAdd %float %sum %step
OpBranch %head
%merge = OpLabel
OpStore %out %sum
OpReturn
)");
  EXPECT_EQ(countIn(promotedAssembly(main + callee), Op::OpFunctionCall), 1);
}

}  // namespace
}  // namespace reprise
