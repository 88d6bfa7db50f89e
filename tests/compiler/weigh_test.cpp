// Weighing all values by one dominator tree says what weighing each by itself says.
#include <gtest/gtest.h>

#include "compiler/candidates/need_dominators.h"
#include "compiler/candidates/weigh.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

class Weigh : public testing::TestWithParam<std::string> {};

// Every value of the shader as a payload, with a guard where asked for.
void expectEqualWeights(const PreparedShader& shader, const ShaderAnalysis& analysis, bool guarded) {
  const NeedDominators dominators(analysis.graph);
  int weighed = 0;
  for (std::size_t node = 0; node < analysis.graph.nodes.size(); ++node) {
    if (!analysis.live[node] || analysis.graph.nodes[node].instruction->type_id == 0) continue;
    CandidateValue value;
    value.node = static_cast<int>(node);
    if (guarded) value.guard_channel = 1;
    const WeighedPayload alone = weighPayload(analysis, {value}), together = weighSingle(analysis, dominators, value);
    ASSERT_EQ(together.saved_cost, alone.saved_cost) << node;
    ASSERT_EQ(together.slice_cost, alone.slice_cost) << node;
    ASSERT_EQ(together.slice_takes_derivatives, alone.slice_takes_derivatives) << node;
    ASSERT_EQ(together.tail_takes_derivatives, alone.tail_takes_derivatives) << node;
    ++weighed;
  }
  EXPECT_GT(weighed, 5) << shader.entry_function;
}

TEST_P(Weigh, TheSameTogetherAsAlone) {
  const PreparedShader shader = prepareForCaching(readModule(compile(GetParam(), {}).value().words).value(), "").value();
  const ShaderAnalysis analysis = analyse(shader);
  expectEqualWeights(shader, analysis, false);
  expectEqualWeights(shader, analysis, true);
}

std::vector<std::string> weighedShaders() {
  std::vector<std::string> files = shippedFragmentShaders();
  for (const char* trap : {"loop_nested", "loop_varying_exit", "implicit_lod_in_branch", "derivatives_of_payload", "switch_in_loop", "local_array_indexed"})
    files.push_back(REPRISE_SOURCE_DIR "/tests/check/traps/" + std::string(trap) + ".frag");
  return files;
}

INSTANTIATE_TEST_SUITE_P(Shader, Weigh, testing::ValuesIn(weighedShaders()), [](const auto& test) { return stemOf(test.param); });

}  // namespace
}  // namespace reprise
