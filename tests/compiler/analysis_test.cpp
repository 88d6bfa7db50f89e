// What values depend on, what they are called, where they stand, and which shaders cannot be cached at all.
#include <gtest/gtest.h>

#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

constexpr const char* kHead =
    "#version 450\n"
    "layout(set = 0, binding = 0) uniform Scene { vec4 camera; vec4 tint; } scene;\n"
    "layout(set = 0, binding = 1) uniform sampler2D albedo_map;\n"
    "layout(location = 0) in vec4 p;\n"
    "layout(location = 1) in vec4 q;\n"
    "layout(location = 0) out vec4 color;\n";

std::unique_ptr<AnalysedShader> analysedMain(const std::string& body, const std::string& functions = "") {
  return analysedWhole(kHead + functions + "void main() {\n" + body + "\n}\n");
}

using Names = std::vector<std::string>;

TEST(Inputs, AreThoseOfTheData) {
  const auto shader = analysedMain(
      "float a = sin(p.x * 3.0);\n"
      "float b = a * dot(scene.camera, q);\n"
      "vec4 c = texture(albedo_map, p.xy) * b;\n"
      "float d = sin(gl_FragCoord.x) * c.x;\n"
      "color = c + d;");
  EXPECT_EQ(shader->inputsOf("a"), (Names{"varying p"}));
  EXPECT_EQ(shader->inputsOf("b"), (Names{"uniform Scene.camera", "varying p", "varying q"}));
  EXPECT_EQ(shader->inputsOf("c"), (Names{"texture albedo_map", "uniform Scene.camera", "varying p", "varying q"}));
  EXPECT_EQ(shader->inputsOf("d"),
            (Names{"built-in FragCoord", "texture albedo_map", "uniform Scene.camera", "varying p", "varying q"}));
}

TEST(Inputs, FollowTheConditionOfABranch) {
  const auto shader = analysedMain(
      "float a = 1.0;\n"
      "if (q.y > 0.0) a = 2.0; else a = 3.0;\n"
      "float b = sin(a);\n"
      "color = vec4(b * p.x);");
  EXPECT_EQ(shader->inputsOf("b"), (Names{"varying q"}));
}

TEST(Inputs, FollowTheBoundOfALoopAndWhatItCarries) {
  const auto shader = analysedMain(
      "float sum = 0.0;\n"
      "float carried = p.x;\n"
      "for (int i = 0; i < int(scene.tint.x); ++i) { sum += carried; carried = sin(carried + q.x); }\n"
      "float b = cos(sum);\n"
      "color = vec4(b);");
  EXPECT_EQ(shader->inputsOf("b"), (Names{"uniform Scene.tint", "varying p", "varying q"}));
}

TEST(Inputs, FollowABreak) {
  const auto shader = analysedMain(
      "float sum = 0.0;\n"
      "for (int i = 0; i < 8; ++i) { if (sum > q.x) break; sum += 1.0; }\n"
      "float b = cos(sum);\n"
      "color = vec4(b * p.x);");
  EXPECT_EQ(shader->inputsOf("b"), (Names{"varying q"}));
}

TEST(Inputs, FollowAnEarlyReturnOfAFunction) {
  const auto shader = analysedMain("float b = cos(chosen());\ncolor = vec4(b * p.x);",
                                   "float chosen() { if (q.z > 0.5) return 2.0; return 3.0; }\n");
  EXPECT_EQ(shader->inputsOf("b"), (Names{"varying q"}));
}

TEST(Inputs, FollowASwitch) {
  const auto shader = analysedMain(
      "float a = 0.0;\n"
      "switch (int(q.w)) { case 0: a = 1.0; break; case 1: a = 5.0; break; default: a = p.x; }\n"
      "float b = cos(a);\n"
      "color = vec4(b);");
  EXPECT_EQ(shader->inputsOf("b"), (Names{"varying p", "varying q"}));
}

TEST(Inputs, FollowLocalArraysThatAreIndexedByInputs) {
  const auto shader = analysedMain(
      "float table[4];\n"
      "table[0] = p.x; table[1] = sin(p.y); table[2] = 0.5; table[3] = scene.tint.x;\n"
      "float b = cos(table[int(q.x)]);\n"
      "color = vec4(b);");
  EXPECT_EQ(shader->inputsOf("b"), (Names{"uniform Scene.tint", "varying p", "varying q"}));
}

TEST(Inputs, FollowTheConditionOfAStoreToALocalArray) {
  const auto shader = analysedMain(
      "float table[4] = float[](0.0, 1.0, 2.0, 3.0);\n"
      "if (q.x > 0.5) table[1] = 9.0;\n"
      "float b = cos(table[int(p.x)]);\n"
      "color = vec4(b);");
  EXPECT_EQ(shader->inputsOf("b"), (Names{"varying p", "varying q"}));
}

TEST(Names, SurviveInliningAndSsa) {
  const auto shader = analysedMain("float vein = wave(p.x);\ncolor = vec4(vein * q);",
                                   "float wave(float x) { float inner = sin(3.0 * x); return inner * inner; }\n");
  const Candidate& vein = shader->named("vein");
  EXPECT_EQ(vein.type, "float");
  EXPECT_EQ(vein.channels, 1);
  EXPECT_EQ(vein.operation, "FMul");
  EXPECT_EQ(shader->named("inner").operation, "ExtInst");
}

TEST(Names, SurviveThroughAFunctionWithTwoExits) {
  const auto shader = analysedMain("float vein = wave(p.x);\ncolor = vec4(vein * q);",
                                   "float wave(float x) { if (x < 0.0) return exp(x); return sqrt(x) + sin(x); }\n");
  EXPECT_EQ(shader->named("vein").operation, "Phi");
}

TEST(Names, OfParametersThatAreWrittenOutCount) {
  const auto shader = analysedMain("float vein;\nwave(p.x, vein);\ncolor = vec4(vein * q);",
                                   "void wave(float x, out float result) { result = sin(3.0 * x); }\n");
  EXPECT_EQ(shader->named("vein").operation, "ExtInst");
}

TEST(Places, AreFileLineAndColumnOfTheName) {
  const auto shader = analysedMain("  float first = sin(p.x);\n  float vein = first * cos(p.y);\n  color = vec4(vein * q);");
  // Six lines of head, one of main.
  EXPECT_EQ(shader->named("first").place, (Place{"test.frag", 8, 9}));
  EXPECT_EQ(shader->named("vein").place, (Place{"test.frag", 9, 9}));
  EXPECT_EQ(shader->named("vein").id, "vein@test.frag:9");
}

TEST(Places, AreUnknownInTheColumnWithoutTheSource) {
  const auto shader = analysedMain("float vein = sin(p.x);\ncolor = vec4(vein * q);");
  const Node& vein = shader->analysis.graph.nodes[static_cast<std::size_t>(shader->named("vein").values.front().node)];
  const Place place = placeOf(shader->shader, *vein.instruction, {});
  EXPECT_EQ(place, (Place{"test.frag", 8, 0}));
}

TEST(Analysis, WhatNoOutputNeedsIsDead) {
  const auto shader = analysedMain("float unused = sin(p.x);\nfloat used = cos(p.y);\ncolor = vec4(used * q);");
  for (const Candidate& candidate : shader->candidates) EXPECT_NE(candidate.name, "unused");
  EXPECT_EQ(shader->named("used").operation, "ExtInst");
}

TEST(Analysis, AWholeLoopCostsItsIterations) {
  const auto with = [](const std::string& count) {
    return analysedMain("float sum = 0.0;\nfor (int i = 0; i < " + count + "; ++i) sum += sin(p.x + sum);\ncolor = vec4(sum);")
        ->analysis.total_cost;
  };
  const double four = with("4"), eight = with("8"), twelve = with("12");
  EXPECT_GT(eight, four);
  EXPECT_DOUBLE_EQ(twelve - eight, eight - four);
}

TEST(Analysis, DerivativesAndDiscardsAreNoticed) {
  const auto plain = analysedMain("color = sin(p);");
  EXPECT_FALSE(plain->analysis.takes_derivatives);
  EXPECT_FALSE(plain->analysis.discards);
  const auto sampling = analysedMain("if (p.x < 0.0) discard;\ncolor = texture(albedo_map, p.xy);");
  EXPECT_TRUE(sampling->analysis.takes_derivatives);
  EXPECT_TRUE(sampling->analysis.discards);
  EXPECT_TRUE(analysedMain("color = dFdx(p);")->analysis.takes_derivatives);
  EXPECT_FALSE(analysedMain("color = textureLod(albedo_map, p.xy, 0.0);")->analysis.takes_derivatives);
}

std::string refusalOf(const std::string& body, const std::string& globals, const std::string& extension = "") {
  const auto shader = analysedWhole("#version 450\n" + extension + globals +
                                    "layout(location = 0) in vec4 p;\nlayout(location = 0) out vec4 color;\nvoid main() {\n" +
                                    body + "\n  color = sin(p) * exp(p.x);\n}\n");
  if (!shader->analysis.refusal) return "";
  EXPECT_EQ(shader->analysis.refusal->kind, ErrorKind::kRefused);
  EXPECT_FALSE(shader->analysis.refusal->message.empty());
  for (const Candidate& candidate : shader->candidates) EXPECT_FALSE(candidate.kept()) << candidate.id;
  return shader->analysis.refusal->code;
}

TEST(Refusals, ShadersThatWriteMemory) {
  EXPECT_EQ(refusalOf("imageStore(target, ivec2(p.xy), p);", "layout(set = 0, binding = 0, rgba8) uniform writeonly image2D target;\n"),
            "shader.side_effects");
  EXPECT_EQ(refusalOf("log_.last = p;", "layout(set = 0, binding = 0) buffer Log { vec4 last; } log_;\n"), "shader.side_effects");
  EXPECT_EQ(refusalOf("log_.all[int(p.x)].y = 2.0;", "layout(set = 0, binding = 0) buffer Log { vec4 all[16]; } log_;\n"),
            "shader.side_effects");
  EXPECT_EQ(refusalOf("atomicAdd(log_.count, 1u);", "layout(set = 0, binding = 0) buffer Log { uint count; } log_;\n"),
            "shader.side_effects");
  EXPECT_EQ(refusalOf("imageAtomicAdd(target, ivec2(p.xy), 1u);", "layout(set = 0, binding = 0, r32ui) uniform uimage2D target;\n"),
            "shader.side_effects");
}

TEST(Refusals, SubgroupsAndSampleRate) {
  EXPECT_EQ(refusalOf("if (subgroupAny(p.x > 0.0)) discard;", "", "#extension GL_KHR_shader_subgroup_vote : require\n"), "shader.subgroup");
  EXPECT_EQ(refusalOf("if (gl_SampleID == 1) discard;", ""), "shader.sample_rate");
}

TEST(Refusals, ReadingABufferIsNone) {
  EXPECT_EQ(refusalOf("if (log_.last.x > p.x) discard;", "layout(set = 0, binding = 0) readonly buffer Log { vec4 last; } log_;\n"), "");
}

}  // namespace
}  // namespace reprise
