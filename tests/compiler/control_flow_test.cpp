// Dominance, control dependence, loops and iteration counts on graphs small enough to check by hand.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/analysis/value_graph.h"
#include "compiler/ir/control_flow.h"
#include "compiler/ir/inline_calls.h"
#include "compiler/ir/promote_to_ssa.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

// Block i ends with a branch to the blocks listed for it: one, two (conditional), more (switch), or none (return).
Function graphOf(const std::vector<std::vector<std::uint32_t>>& targets) {
  constexpr std::uint32_t kFirstLabel = 10, kCondition = 1;
  Function function;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    std::vector<Operand> labels;
    for (const std::uint32_t target : targets[i]) labels.push_back(idOperand(kFirstLabel + target));
    spv::Op opcode = spv::Op::OpReturn;
    if (labels.size() == 1) opcode = spv::Op::OpBranch;
    if (labels.size() == 2) opcode = spv::Op::OpBranchConditional;
    if (labels.size() > 2) {
      opcode = spv::Op::OpSwitch;
      for (std::size_t literal = 1; literal < targets[i].size(); ++literal)
        labels.insert(labels.begin() + static_cast<std::ptrdiff_t>(2 * literal - 1), literalOperand(static_cast<std::uint32_t>(literal)));
    }
    if (labels.size() > 1) labels.insert(labels.begin(), idOperand(kCondition));
    function.blocks.push_back({kFirstLabel + static_cast<std::uint32_t>(i), {makeInstruction(opcode, 0, 0, labels)}});
  }
  return function;
}

std::vector<int> sorted(std::vector<int> values) {
  std::sort(values.begin(), values.end());
  return values;
}

using Blocks = std::vector<int>;

TEST(ControlFlow, BothArmsOfAnIfDependOnItAndTheJoinDoesNot) {
  const ControlFlow flow = analyseControlFlow(graphOf({{1, 2}, {3}, {3}, {}}));
  EXPECT_EQ(flow.immediate_dominator, (Blocks{kNoBlock, 0, 0, 0}));
  EXPECT_EQ(flow.controllers[1], Blocks{0});
  EXPECT_EQ(flow.controllers[2], Blocks{0});
  EXPECT_TRUE(flow.controllers[0].empty());
  EXPECT_TRUE(flow.controllers[3].empty());
  EXPECT_TRUE(flow.loops.empty());
  EXPECT_TRUE(dominates(flow, 0, 3));
  EXPECT_TRUE(dominates(flow, 2, 2));
  EXPECT_FALSE(dominates(flow, 1, 3));
}

TEST(ControlFlow, ALoopHasItsHeaderBodyAndLatchAndIsItsOwnController) {
  // 0 -> 1 header -> 2 body -> 3 latch -> 1; 1 -> 4 after.
  const ControlFlow flow = analyseControlFlow(graphOf({{1}, {2, 4}, {3}, {1}, {}}));
  ASSERT_EQ(flow.loops.size(), 1u);
  EXPECT_EQ(flow.loops[0].header, 1);
  EXPECT_EQ(flow.loops[0].contains, (std::vector<bool>{false, true, true, true, false}));
  EXPECT_EQ(flow.controllers[1], Blocks{1});
  EXPECT_EQ(flow.controllers[2], Blocks{1});
  EXPECT_EQ(flow.controllers[3], Blocks{1});
  EXPECT_TRUE(flow.controllers[4].empty());
  EXPECT_EQ(flow.immediate_dominator, (Blocks{kNoBlock, 0, 1, 2, 1}));
}

TEST(ControlFlow, ABreakControlsWhatTheLoopDoesAfterIt) {
  // 1 header -> 2; 2 breaks to 5 or goes to 3 -> 4 latch -> 1.
  const ControlFlow flow = analyseControlFlow(graphOf({{1}, {2, 5}, {3, 5}, {4}, {1}, {}}));
  EXPECT_EQ(flow.controllers[3], Blocks{2});
  EXPECT_EQ(flow.controllers[4], Blocks{2});
  EXPECT_EQ(sorted(flow.controllers[1]), Blocks{2}) << "another round needs that the break was not taken";
  EXPECT_EQ(flow.controllers[2], Blocks{1});
  EXPECT_TRUE(flow.controllers[5].empty());
}

TEST(ControlFlow, NestedLoopsAreTwoAndTheInnerLiesInTheOuter) {
  const ControlFlow flow = analyseControlFlow(graphOf({{1}, {2, 5}, {3, 4}, {2}, {1}, {}}));
  ASSERT_EQ(flow.loops.size(), 2u);
  EXPECT_EQ(flow.loops[0].header, 1);
  EXPECT_EQ(flow.loops[0].contains, (std::vector<bool>{false, true, true, true, true, false}));
  EXPECT_EQ(flow.loops[1].header, 2);
  EXPECT_EQ(flow.loops[1].contains, (std::vector<bool>{false, false, true, true, false, false}));
}

TEST(ControlFlow, WhatFollowsAnEarlyReturnDependsOnItsCondition) {
  const ControlFlow flow = analyseControlFlow(graphOf({{1, 2}, {}, {3}, {}}));
  EXPECT_EQ(flow.controllers[1], Blocks{0});
  EXPECT_EQ(flow.controllers[2], Blocks{0});
  EXPECT_EQ(flow.controllers[3], Blocks{0});
}

TEST(ControlFlow, CasesOfASwitchDependOnItAlsoWhereTheyFallThrough) {
  // 1 falls through into 2; 3 is the default; 4 the join.
  const ControlFlow flow = analyseControlFlow(graphOf({{3, 1, 2}, {2}, {4}, {4}, {}}));
  EXPECT_EQ(sorted(flow.successors[0]), (Blocks{1, 2, 3}));
  for (const std::size_t block : {1u, 2u, 3u}) EXPECT_EQ(flow.controllers[block], Blocks{0}) << block;
  EXPECT_TRUE(flow.controllers[4].empty());
  EXPECT_EQ(flow.immediate_dominator, (Blocks{kNoBlock, 0, 0, 0, 0}));
}

TEST(ControlFlow, UnreachableBlocksAreToldApartAndChangeNothing) {
  const ControlFlow flow = analyseControlFlow(graphOf({{2}, {2}, {}}));
  EXPECT_EQ(flow.reachable, (std::vector<bool>{true, false, true}));
  EXPECT_EQ(flow.order, (Blocks{0, 2}));
  EXPECT_EQ(flow.immediate_dominator[1], kNoBlock);
  EXPECT_EQ(flow.immediate_dominator[2], 0);
}

TEST(ControlFlow, ALoopWithoutAWayOutIsALoopAndItsBranchesControl) {
  const ControlFlow flow = analyseControlFlow(graphOf({{1}, {2, 3}, {1}, {1}}));
  ASSERT_EQ(flow.loops.size(), 1u);
  EXPECT_NE(std::count(flow.controllers[2].begin(), flow.controllers[2].end(), 1), 0);
  EXPECT_NE(std::count(flow.controllers[3].begin(), flow.controllers[3].end(), 1), 0);
}

// Iterations of the only loop of a shader whose main has this loop head, as it is before short loops are written out.
int iterationsOf(const std::string& loop) {
  const Module shader = moduleOf("#version 450\nlayout(location = 0) in vec4 p;\nlayout(location = 0) out vec4 color;\n"
                               "void main() {\n  float sum = 0.0;\n  " + loop + "\n  color = vec4(sum);\n}\n");
  const Module promoted = promoteToSsa(inlineCalls(shader).value()).value();
  const Function& entry = *findFunction(promoted, promoted.entry_points.front().word(1));
  const ControlFlow flow = analyseControlFlow(entry);
  REPRISE_CHECK(flow.loops.size() == 1, flow.loops.size());
  return estimateIterations(promoted, entry, flow, flow.loops[0]);
}

TEST(Iterations, AreExactForCountedLoops) {
  EXPECT_EQ(iterationsOf("for (int i = 0; i < 24; ++i) sum += sin(p.x + sum);"), 24);
  EXPECT_EQ(iterationsOf("for (int i = 1; i <= 9; i += 2) sum += sin(p.x + sum);"), 5);
  EXPECT_EQ(iterationsOf("for (int i = 10; i > 0; i -= 3) sum += sin(p.x + sum);"), 4);
  EXPECT_EQ(iterationsOf("for (int i = 3; i >= -3; --i) sum += sin(p.x + sum);"), 7);
  EXPECT_EQ(iterationsOf("for (uint i = 2u; i < 7u; ++i) sum += sin(p.x + sum);"), 5);
  EXPECT_EQ(iterationsOf("for (int i = 0; i < 1; ++i) sum += sin(p.x + sum);"), 1);
}

TEST(Iterations, ABreakDoesNotHideTheCount) {
  EXPECT_EQ(iterationsOf("for (int i = 0; i < 12; ++i) { if (sum > p.y) break; sum += sin(p.x + sum); }"), 12);
}

TEST(Iterations, ABranchOnTheCounterIsNotTheEndOfTheLoop) {
  EXPECT_EQ(iterationsOf("for (int i = 0; i < 12; ++i) { if (i < 3) sum += sin(p.x + sum); else sum += 1.0; }"), 12);
}

TEST(Iterations, OfALoopThatComparesTheNextValueAreAGuessAndNotAnInnerBranchsBound) {
  EXPECT_EQ(iterationsOf("int i = 0; do { if (i < 3) sum += sin(p.x + sum); ++i; } while (i < 24);"), kUnknownIterations);
}

TEST(Iterations, AreAGuessWhereAnInputDecides) {
  EXPECT_EQ(iterationsOf("for (int i = 0; i < int(p.z); ++i) sum += sin(p.x + sum);"), kUnknownIterations);
  EXPECT_EQ(iterationsOf("while (sum < 3.0) sum += abs(p.x) + 0.1;"), kUnknownIterations);
}

}  // namespace
}  // namespace reprise
