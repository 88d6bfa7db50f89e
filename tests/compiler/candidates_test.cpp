// Which values are kept, why the others are dropped, and in which order.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

constexpr const char* kHead =
    "#version 450\n"
    "layout(set = 0, binding = 0) uniform Scene { vec4 camera; } scene;\n"
    "layout(set = 0, binding = 1) uniform sampler2D albedo_map;\n"
    "layout(location = 0) in vec4 p;\n"
    "layout(location = 1) in vec4 q;\n"
    "layout(location = 0) out vec4 color;\n";

std::string reasonOf(const std::string& body, const std::string& name) {
  return analysedWhole(kHead + ("void main() {\n" + body + "\n}\n"))->named(name).dropped.code;
}

TEST(Candidates, AValueInALoopIsDroppedAndTheSumAfterItIsNot) {
  const auto shader = analysed(kHead + std::string("void main() {\n"
                                                   "float sum = 0.0;\n"
                                                   "for (int i = 0; i < 48; ++i) { float wave = sin(p.x * float(i)); sum += wave; }\n"
                                                   "float total = sum * 0.25;\n"
                                                   "color = vec4(total) * dot(scene.camera, q);\n}\n"));
  EXPECT_EQ(shader->named("wave").dropped.code, "place.loop");
  EXPECT_TRUE(shader->named("total").kept()) << shader->named("total").dropped.message;
  EXPECT_GT(shader->named("total").share, 0.5);
}

TEST(Candidates, AUniformOnlyValueIsDropped) {
  EXPECT_EQ(reasonOf("float glow = exp(sin(scene.camera.x));\ncolor = glow * sin(p);", "glow"), "value.uniform");
  EXPECT_EQ(reasonOf("float glow = exp(sin(p.x));\ncolor = glow * sin(p * scene.camera);", "glow"), "");
}

TEST(Candidates, MereRearrangementsAndWideTypesAreDropped) {
  const auto shader = analysedWhole(kHead + std::string("void main() {\nvec2 both = vec2(sin(p.x), cos(p.y));\n"
                                                        "double fine = double(p.z) * 3.0lf;\n"
                                                        "color = vec4(both, float(fine), 1.0) * q;\n}\n"));
  EXPECT_EQ(shader->named("both").dropped.code, "value.rearranged");
  EXPECT_EQ(shader->named("fine").dropped.code, "type.unsupported");
  EXPECT_EQ(shader->named("fine").type, "other");
}

struct KeptValue {
  const char *statement, *use;
  const char* type;
  int channels;
  bool integer;
};

TEST(Candidates, IntegersBooleansAndHalfFloatsCanBeKept) {
  const KeptValue all[] = {
      {"int kept_value = int(exp(sin(p.x)) * 9.0) * 7;", "float(kept_value * int(scene.camera.x))", "int", 1, true},
      {"uvec3 kept_value = uvec3(exp(p.xyz)) * 5u;", "vec4(kept_value * uvec3(scene.camera), 1.0)", "uvec3", 3, true},
      {"bvec2 kept_value = greaterThan(sin(exp(p.zw)), vec2(0.5));", "mix(scene.camera.xy, q.xy, kept_value).xyxy",
       "bvec2", 2, true},
      {"bool kept_value = sin(exp(p.z)) > 0.5;", "(kept_value ? scene.camera.x : 3.0)", "bool", 1, true},
      {"f16vec2 kept_value = f16vec2(sin(p.xy)) * float16_t(3.0);", "vec2(kept_value * f16vec2(scene.camera)).xyxy",
       "f16vec2", 2, false},
      {"float16_t kept_value = float16_t(sin(p.x)) * float16_t(3.0);", "float(kept_value * float16_t(scene.camera.x))",
       "float16_t", 1, false}};
  std::string head = kHead;
  head.insert(head.find('\n') + 1, "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n");
  for (const KeptValue& one : all) {
    SCOPED_TRACE(one.type);
    const auto shader =
        analysedWhole(head + "void main() {\n" + one.statement + "\ncolor = " + one.use + " * q;\n}\n");
    const Candidate& candidate = shader->named("kept_value");
    EXPECT_TRUE(candidate.kept()) << candidate.dropped.message;
    EXPECT_EQ(candidate.type, one.type);
    EXPECT_EQ(candidate.channels, one.channels);
    EXPECT_EQ(isInteger(candidate.scalar), one.integer);
  }
}

TEST(Candidates, ATextureCoordinateIsDroppedWhereTheSampleTakesItsDerivative) {
  EXPECT_EQ(reasonOf("vec2 bent = p.xy + 0.1 * sin(q.xy);\ncolor = texture(albedo_map, bent) * q;", "bent"), "tail.derivative");
  EXPECT_EQ(reasonOf("float bend = sin(q.x);\ncolor = texture(albedo_map, p.xy + bend) * q;", "bend"), "tail.derivative");
  EXPECT_EQ(reasonOf("float bend = exp(sin(q.x));\ncolor = textureLod(albedo_map, p.xy + bend, 0.0) * q;", "bend"), "");
  EXPECT_EQ(reasonOf("float slope = exp(sin(q.x));\ncolor = vec4(dFdx(slope)) * q;", "slope"), "tail.derivative");
}

TEST(Candidates, ASampleUnderABranchOnThePayloadIsDropped) {
  EXPECT_EQ(reasonOf("float mask = exp(sin(q.x));\ncolor = q;\nif (mask > 0.5) color = texture(albedo_map, p.xy);", "mask"),
            "tail.derivative");
}

TEST(Candidates, TheSampleItselfMayBeKept) {
  const auto shader = analysedWhole(kHead + std::string("void main() {\nvec3 albedo = texture(albedo_map, p.xy).rgb * sin(p.xyz);\n"
                                                        "color = vec4(albedo * dot(scene.camera, q), 1.0);\n}\n"));
  EXPECT_TRUE(shader->named("albedo").kept()) << shader->named("albedo").dropped.message;
  EXPECT_TRUE(shader->named("albedo").slice_takes_derivatives);
}

TEST(Candidates, AValueOfOneBranchIsConditional) {
  const auto shader = analysedWhole(kHead + std::string("void main() {\ncolor = q;\n"
                                                        "if (q.x > 0.0) { float rare = exp(sin(p.x)); color = vec4(rare * q); }\n"
                                                        "float always = exp(cos(p.y));\ncolor += always * q;\n}\n"));
  EXPECT_TRUE(shader->named("rare").conditional);
  EXPECT_FALSE(shader->named("always").conditional);
}

TEST(Candidates, AValueAfterADiscardIsNotConditional) {
  const auto shader = analysedWhole(kHead + std::string("void main() {\nif (q.x > 0.0) discard;\n"
                                                        "float vein = exp(sin(p.x));\ncolor = vein * q;\n}\n"));
  EXPECT_FALSE(shader->named("vein").conditional);
}

class ShippedFragmentShader : public testing::TestWithParam<std::string> {
 protected:
  std::vector<Candidate> candidates(const CandidateOptions& options = {}) {
    program_ = shippedProgram(GetParam());
    return enumerateCandidates(*program_.fragment, program_.analysis, program_.sources, options);
  }
  ShaderProgram program_;
};

TEST_P(ShippedFragmentShader, EveryDroppedValueHasAReasonAndIdsAreUnique) {
  const std::set<std::string> reasons = {"type.unsupported", "place.loop",       "value.uniform",    "value.rearranged", "value.coverage", "tail.derivative",
                                         "pruned.cheap",     "pruned.duplicate", "pruned.dominated", "pruned.channels", "pruned.rank", "pruned.many"};
  std::set<std::string> ids;
  int kept = 0;
  for (const Candidate& candidate : candidates()) {
    EXPECT_TRUE(ids.insert(candidate.id).second) << candidate.id << " twice";
    kept += candidate.kept();
    if (candidate.kept()) continue;
    EXPECT_EQ(reasons.count(candidate.dropped.code), 1u) << candidate.dropped.code;
    EXPECT_FALSE(candidate.dropped.message.empty()) << candidate.id;
  }
  EXPECT_GT(kept, 0);
}

TEST_P(ShippedFragmentShader, KeptCandidatesStandFirstWithPlaceInputsAndSavings) {
  bool dropped = false;
  const std::vector<Candidate> all = candidates();
  double saved = program_.analysis.total_cost;
  for (const Candidate& candidate : all) {
    dropped |= !candidate.kept();
    if (!candidate.kept()) continue;
    EXPECT_FALSE(dropped) << candidate.id << " after dropped ones";
    EXPECT_LE(candidate.saved_cost, saved);
    saved = candidate.saved_cost;
    EXPECT_GE(candidate.share, CandidateOptions{}.least_share);
    EXPECT_LE(candidate.share, 1.0);
    EXPECT_GE(candidate.slice_cost, candidate.saved_cost - 1e-9) << "a hit cannot save more than the slice costs";
    EXPECT_GT(candidate.place.line, 0);
    EXPECT_GT(candidate.place.column, 0);
    EXPECT_FALSE(candidate.inputs.empty());
    EXPECT_GE(candidate.channels, 1);
    EXPECT_LE(candidate.channels, static_cast<int>(kMostPayloadChannels));
  }
}

TEST_P(ShippedFragmentShader, TheRankingIsTheSameEveryTime) {
  const std::vector<Candidate> first = candidates(), second = candidates();
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].id, second[i].id);
    EXPECT_EQ(first[i].values.front().value, second[i].values.front().value);
    EXPECT_EQ(first[i].saved_cost, second[i].saved_cost);
    EXPECT_EQ(first[i].dropped.code, second[i].dropped.code);
  }
}

TEST_P(ShippedFragmentShader, AShorterListIsAPrefixOfALongerOne) {
  CandidateOptions two, one;
  two.most = 2;
  one.most = 1;
  const std::vector<Candidate> all = candidates(), shorter = candidates(two), shortest = candidates(one);
  const auto kept = [](const std::vector<Candidate>& list) {
    std::vector<std::string> ids;
    for (const Candidate& candidate : list)
      if (candidate.kept()) ids.push_back(candidate.id);
    return ids;
  };
  std::vector<std::string> expected = kept(all);
  expected.resize(std::min<std::size_t>(expected.size(), 2));
  EXPECT_EQ(kept(shorter), expected);
  expected.resize(std::min<std::size_t>(expected.size(), 1));
  EXPECT_EQ(kept(shortest), expected);
}

INSTANTIATE_TEST_SUITE_P(Candidates, ShippedFragmentShader, testing::ValuesIn(shippedFragmentShaders()),
                         [](const auto& parameter) { return stemOf(parameter.param); });

TEST(Candidates, TheMarblesAlbedoIsAmongThem) {
  const ShaderProgram program = shippedProgram(std::string(REPRISE_SOURCE_DIR) + "/shaders/marble/marble.frag");
  const auto candidates = enumerateCandidates(*program.fragment, program.analysis, program.sources, {});
  const auto noise = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
    return candidate.kept() && inputNames(candidate, program.analysis) == std::vector<std::string>{"varying object_position"};
  });
  ASSERT_NE(noise, candidates.end());
  EXPECT_GT(noise->share, 0.5);
}

}  // namespace
}  // namespace reprise
