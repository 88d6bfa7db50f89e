// Payloads are found again by the structure of their slices: after edits elsewhere, and not after edits of what they are.
#include "compiler/candidates/find_payload.h"

#include <gtest/gtest.h>

#include <string>

#include "compiler/strategies/build_recipe.h"
#include "runtime/package/package.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

const std::string kShader = R"(#version 450
layout(set = 0, binding = 0) uniform Frame { vec3 eye; float gain; } frame;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec4 color;
float veins(vec3 p) {
  float sum = 0.0;
  for (int i = 0; i < 40; ++i) { sum += sin(p.x + 0.3 * sin(p.y)) / float(i + 1); p = p.yzx * 1.3; }
  return sum;
}
void main() {
  float stone = veins(position * frame.gain);
  float facing = dot(normalize(normal), normalize(frame.eye - position));
  color = vec4(vec3(stone) * facing, 1.0);
}
)";

std::string edited(const std::string& from, const std::string& to) {
  std::string text = kShader;
  const std::size_t at = text.find(from);
  REPRISE_CHECK(at != std::string::npos, from);
  return text.replace(at, from.size(), to);
}

std::vector<IdentifiedValue> stone() {
  const auto before = analysedWhole(kShader);
  return identifyPayload(before->shader, before->analysis, before->named("stone"));
}

Result<Candidate> stoneIn(const std::string& text) {
  const auto after = analysedWhole(text);
  return findPayload(after->shader, after->analysis, after->sources, stone());
}

TEST(FindPayload, SurvivesEditsElsewhere) {
  for (const std::string& text :
       {edited("vec4(vec3(stone) * facing, 1.0)", "vec4(sqrt(vec3(stone)) * facing + 0.1, 1.0)"),
        edited("float facing = dot", "float rim = 0.5;\n  float facing = rim * dot"),
        edited("{ vec3 eye; float gain; }", "{ mat4 spare; vec3 eye; float fog; float gain; }"),
        edited("float sum = 0.0;", "\n\n// A comment.\n  float sum = 0.0;"),
        edited("layout(location = 1) in vec3 normal;", "layout(location = 2) in vec2 uv;\nlayout(location = 1) in vec3 normal;")}) {
    const Result<Candidate> found = stoneIn(text);
    ASSERT_TRUE(found.ok()) << text << formatError(found.error());
    EXPECT_EQ(found->name, "stone");
  }
}

TEST(FindPayload, SurvivesNewNamesOfThePayloadAndItsLocals) {
  std::string text = kShader;
  for (const auto& [from, to] : {std::pair{"float sum", "float total"}, {"sum +=", "total +="}, {"return sum", "return total"},
                                 {"float stone", "float marble"}, {"vec3(stone)", "vec3(marble)"}})
    text.replace(text.find(from), std::string(from).size(), to);
  const Result<Candidate> found = stoneIn(text);
  ASSERT_TRUE(found.ok()) << formatError(found.error());
  EXPECT_EQ(found->name, "marble");
}

TEST(FindPayload, SaysWhatOfTheSliceChanged) {
  struct Case {
    std::string from, to, said;
  };
  for (const Case& one : {Case{"0.3 * sin", "0.4 * sin", "a constant"}, Case{"i < 40", "i < 41", "a constant"},
                          Case{"position * frame.gain", "position * frame.gain * normal.x", "now depends on varying normal"},
                          Case{"position * frame.gain", "position", "no longer depends on uniform Frame.gain"},
                          Case{"0.3 * sin(p.y)", "0.3 * cos(p.y)", "changed"},
                          Case{"float stone = veins(position * frame.gain)", "float other = veins(position + frame.gain)", "no longer in the shader"}}) {
    std::string text = edited(one.from, one.to);
    if (one.said == "no longer in the shader") text.replace(text.find("vec3(stone)"), 11, "vec3(other)");
    const Result<Candidate> found = stoneIn(text);
    ASSERT_FALSE(found.ok()) << text;
    EXPECT_EQ(found.error().code, "choice.stale");
    EXPECT_NE(found.error().message.find(one.said), std::string::npos) << found.error().message;
  }
}

TEST(FindPayload, RefusesWhatCanNoLongerBeKept) {
  const Result<Candidate> found = stoneIn(edited("color = vec4(vec3(stone)", "if (stone < 0.2) discard;\n  color = vec4(vec3(stone)"));
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().code, "choice.unsafe");
  EXPECT_NE(found.error().message.find("discarded"), std::string::npos) << found.error().message;
}

// Whatever can be chosen is found again in the same shader and gives the same recipe, groups and parts of chains included.
class FoundAgain : public testing::TestWithParam<std::string> {};

TEST_P(FoundAgain, EveryCandidateGivesTheSameRecipe) {
  const ShaderProgram program = shippedProgram(GetParam());
  for (const Candidate& candidate : enumerateCandidates(*program.fragment, program.analysis, program.sources, {})) {
    if (!candidate.kept()) continue;
    Result<Candidate> found = findPayload(*program.fragment, program.analysis, program.sources,
                                          identifyPayload(*program.fragment, program.analysis, candidate));
    ASSERT_TRUE(found.ok()) << candidate.id << ": " << formatError(found.error());
    found->id = candidate.id;
    VariantOptions options;
    options.filter = isInteger(candidate.scalar) ? Filter::kNearest : Filter::kBilinear;
    const Result<BuiltRecipe> before = buildRecipe(program, candidate, options, {}), after = buildRecipe(program, *found, options, {});
    ASSERT_EQ(before.ok(), after.ok()) << candidate.id;
    if (!before.ok()) continue;
    EXPECT_EQ(recipeToJson(before->recipe), recipeToJson(after->recipe)) << candidate.id;
    EXPECT_EQ(before->modules, after->modules) << candidate.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, FoundAgain, testing::ValuesIn(shippedFragmentShaders()),
                         [](const auto& each) { return stemOf(each.param); });

}  // namespace
}  // namespace reprise
