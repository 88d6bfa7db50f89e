// Which inputs decide loops, switches and branches.
#include <gtest/gtest.h>

#include "compiler/analysis/deciding_inputs.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

using Kind = DecidingInput::Kind;

std::vector<DecidingInput> decidingOf(const std::string& body) {
  const auto shader = analysedWhole(
      "#version 450\n"
      "layout(set = 1, binding = 2) uniform Scene { vec4 tint; int count; ivec2 sides; int unused; } scene;\n"
      "layout(set = 1, binding = 3) readonly buffer List { int kinds[]; } list;\n"
      "layout(push_constant) uniform Draw { vec4 shift; int way; } draw;\n"
      "layout(location = 0) in vec4 p;\nlayout(location = 2) flat in ivec2 choice;\nlayout(location = 0) out vec4 color;\n"
      "void main() {\n  float sum = p.x;\n" + body + "\n  color = vec4(sum);\n}\n");
  return decidingInputs(shader->shader, shader->analysis);
}

TEST(DecidingInputs, AreNoneWhereNothingIsDecided) { EXPECT_TRUE(decidingOf("sum += float(scene.count);").empty()); }

TEST(DecidingInputs, AreTheBytesOfAMemberThatBoundsALoop) {
  const auto found = decidingOf("for (int i = 0; i < scene.count + 1; ++i) sum += sin(sum);");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Kind::kBlock);
  EXPECT_EQ(found[0].set, 1u);
  EXPECT_EQ(found[0].binding, 2u);
  EXPECT_EQ(found[0].first_byte, 16u);
  EXPECT_EQ(found[0].end_byte, 24u);
}

TEST(DecidingInputs, OfLoopsAndSwitchesComeBeforeThoseOfBranches) {
  const auto found = decidingOf(
      "if (draw.way == 2) sum += 1.0;\n"
      "switch (choice.y) { case 1: sum = sin(sum); break; case 2: sum = cos(sum); break; }");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind, Kind::kVarying);
  EXPECT_EQ(found[0].location, 2u);
  EXPECT_EQ(found[0].components, 2u);
  EXPECT_TRUE(found[0].is_integer);
  EXPECT_EQ(found[1].kind, Kind::kPushConstants);
  EXPECT_EQ(found[1].first_byte, 16u);
}

TEST(DecidingInputs, AreFollowedThroughBuffersAndFloats) {
  const auto found = decidingOf("for (int i = 0; i < list.kinds[draw.way]; ++i) { if (p.y > 0.5) break; sum += sin(sum); }");
  ASSERT_EQ(found.size(), 3u);
  const auto has = [&](Kind kind, bool is_integer) {
    for (const DecidingInput& one : found)
      if (one.kind == kind && one.is_integer == is_integer) return true;
    return false;
  };
  EXPECT_TRUE(has(Kind::kBlock, false));
  EXPECT_TRUE(has(Kind::kPushConstants, false));
  EXPECT_TRUE(has(Kind::kVarying, false)) << "p, which holds floats";
}

}  // namespace
}  // namespace reprise
