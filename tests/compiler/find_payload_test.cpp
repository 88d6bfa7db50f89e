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

struct Edited {
  std::string from, to, said;
};

std::string saidOf(const std::string& text, const std::vector<IdentifiedValue>& payload) {
  const auto after = analysedWhole(text);
  const Result<Candidate> found = findPayload(after->shader, after->analysis, after->sources, payload);
  if (found.ok()) return "";
  EXPECT_EQ(found.error().code, "choice.stale");
  return found.error().message;
}

TEST(FindPayload, SaysWhatOfTheSliceWasEditedAndWhere) {
  for (const Edited& one :
       {Edited{"0.3 * sin", "0.4 * sin", "the constant 0.3 is now 0.4 (test.frag:8)"}, {"i < 40", "i < 41", "the constant 40 is now 41 (test.frag:8)"},
        {"0.3 * sin(p.y)", "0.3 * cos(p.y)", "`Sin` is now `Cos` (test.frag:8)"}, {"p.yzx * 1.3", "p.yzx * 1.3 + 0.25", "there is an added `FAdd:vec3` of CompositeConstruct:vec3(0.25, 0.25, 0.25) (test.frag:8)"},
        {"sum += sin(p.x", "sum += 0.1 + sin(p.x", "there is an added `FAdd` of 0.1 (test.frag:8)"},
        {"veins(position * frame.gain)", "veins(normal * frame.gain)", "varying 'normal' is read in place of 'position' (test.frag:12)"},
        {"position * frame.gain", "position * frame.gain * normal.x", "it now depends on varying normal"},
        {"position * frame.gain", "position", "there is no more `VectorTimesScalar:vec3` of uniform Frame.gain"},
        {"position * frame.gain", "position", "it no longer depends on uniform Frame.gain"},
        {"float stone = veins(position * frame.gain)", "float stone = normal.x + frame.gain", "is now `"}}) {
    const std::string said = saidOf(edited(one.from, one.to), stone());
    EXPECT_NE(said.find(one.said), std::string::npos) << said;
    EXPECT_EQ(said.find("renamed"), std::string::npos) << said;
  }
}

TEST(FindPayload, SaysThatAnEditedValueIsRenamed) {
  std::string text = edited("0.3 * sin", "0.4 * sin");
  for (const auto& [from, to] : {std::pair{"float stone", "float marble"}, {"vec3(stone)", "vec3(marble)"}})
    text.replace(text.find(from), std::string(from).size(), to);
  const std::string said = saidOf(text, stone());
  EXPECT_NE(said.find("'stone' of line 12 of test.frag is renamed 'marble' and has changed since it was chosen: the constant 0.3 is now 0.4"), std::string::npos) << said;
}

TEST(FindPayload, SaysThatAValueIsGone) {
  std::string text = edited("float stone = veins(position * frame.gain)", "float other = normal.y * frame.gain");
  text.replace(text.find("vec3(stone)"), 11, "vec3(other)");
  EXPECT_NE(saidOf(text, stone()).find("is no longer in the shader"), std::string::npos);
}

TEST(FindPayload, SaysOfOldChoicesWithoutTextWhatThereIsMoreAndLessOf) {
  std::vector<IdentifiedValue> old = stone();
  old[0].text.clear();
  for (const Edited& one : {Edited{"0.3 * sin", "0.4 * sin", "a constant"}, {"i < 40", "i < 41", "a constant"},
                            {"position * frame.gain", "position * frame.gain * normal.x", "now depends on varying normal"},
                            {"position * frame.gain", "position", "no longer depends on uniform Frame.gain"}, {"sum += sin(p.x", "sum += -sin(p.x", "1 FNegate more"}}) {
    const std::string said = saidOf(edited(one.from, one.to), old);
    EXPECT_NE(said.find(one.said), std::string::npos) << said;
  }
}

const std::string kTextured = R"(#version 450
layout(set = 0, binding = 0) uniform sampler2D detail;
layout(set = 0, binding = 1) uniform sampler2D noise;
layout(location = 0) in vec2 uv;
layout(location = 1) in float light;
layout(location = 0) out vec4 color;
void main() {
  float relief = pow(texture(detail, uv * 4.0).r, 2.5) + exp(texture(noise, uv).g) + sin(light) * 0.5;
  color = vec4(relief * light);
}
)";

TEST(FindPayload, SaysWhichTextureIsReadInPlaceOfWhich) {
  const auto before = analysedWhole(kTextured);
  const std::vector<IdentifiedValue> relief = identifyPayload(before->shader, before->analysis, before->named("relief"));
  std::string text = kTextured;
  text.replace(text.find("texture(detail"), 14, "texture(noise");
  const std::string said = saidOf(text, relief);
  EXPECT_NE(said.find("texture 'noise' is read in place of 'detail' (test.frag:8)"), std::string::npos) << said;
  EXPECT_EQ(said.find("no longer depends on texture detail"), std::string::npos) << said;
}

// Of a part of a sum the other terms do not count; lines above move it.
TEST(FindPayload, SaysWhatOfTheKeptTermsOfASumWasEdited) {
  const auto before = analysedWhole(kTextured);
  IdentifiedValue part;
  for (const Candidate& candidate : before->candidates)
    if (isRegrouped(candidate) && candidate.values.size() == 1) part = identifyPayload(before->shader, before->analysis, candidate)[0];
  ASSERT_EQ(part.chain, "sum");
  ASSERT_FALSE(part.text.empty());
  EXPECT_TRUE(part.text[0].starts_with("value = sum(")) << part.text[0];
  std::string text = kTextured;
  for (const auto& [from, to] : {std::pair{"uv * 4.0", "uv * 4.5"}, {".r, 2.5", ".r, 2.75"}, {"uv).g", "uv).b"}, {"void main() {", "\nvoid main() {"}}) text.replace(text.find(from), std::string(from).size(), to);
  const std::string said = saidOf(text, {part});
  const bool names_it = said.find("the constant 2.5 is now 2.75") != std::string::npos || said.find("`CompositeExtract.1` is now `CompositeExtract.2`") != std::string::npos;
  EXPECT_TRUE(names_it) << said;
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
