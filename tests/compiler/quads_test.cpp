// What lanes of a quad see of one another: derivatives of what is read from storage buffers, and derivatives that lanes may reach apart.
#include <gtest/gtest.h>

#include "compiler/strategies/build_package.h"
#include "compiler/strategies/refuse_variant.h"
#include "compiler/strategies/registry.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

constexpr const char* kHead = R"(#version 450
layout(set = 0, binding = 0) uniform Scene { vec4 tint; ivec4 counts; } scene;
layout(std430, set = 0, binding = 1) readonly buffer Materials { vec4 list[8]; } materials;
layout(set = 0, binding = 2) uniform sampler2D map;
layout(location = 0) in vec4 p;
layout(location = 1) flat in vec4 whole;
layout(location = 0) out vec4 color;
)";

std::string mainWith(const std::string& body) { return kHead + ("void main() {\n" + body + "\n}\n"); }
std::unique_ptr<AnalysedShader> analysedMain(const std::string& body) { return analysedWhole(mainWith(body)); }
bool readsBuffers(const std::string& body) { return analysedMain(body)->analysis.derivatives_read_buffers; }
std::size_t parted(const std::string& body) { return analysedMain(body)->analysis.divergence.derivatives.size(); }

TEST(DerivativesOfBuffers, AreSeenThroughDataAndControl) {
  EXPECT_TRUE(readsBuffers("color = dFdx(materials.list[2]);"));
  EXPECT_TRUE(readsBuffers("color = texture(map, p.xy * materials.list[scene.counts.x].zw);"));
  EXPECT_TRUE(readsBuffers("color = p; if (materials.list[1].x > 0.5) color = texture(map, p.xy);")) << "whether it is sampled";
  EXPECT_TRUE(readsBuffers("vec2 at = p.xy; if (materials.list[1].x > 0.5) at = p.yx; color = texture(map, at);")) << "where";
  EXPECT_TRUE(readsBuffers("float sum = 0.0; for (int i = 0; i < int(materials.list[0].x); ++i) sum += p.x; color = vec4(fwidth(sum));"));
}

TEST(DerivativesOfBuffers, AreNoneWhereTheReadServesSomethingElse) {
  EXPECT_FALSE(readsBuffers("color = texture(map, p.xy) * materials.list[2];"));
  EXPECT_FALSE(readsBuffers("color = textureLod(map, materials.list[2].xy, 0.0);"));
  EXPECT_FALSE(readsBuffers("color = texture(map, p.xy * scene.tint.x) + dFdx(p);"));
  EXPECT_FALSE(readsBuffers("vec4 unused = dFdx(materials.list[2]); color = p;")) << "nobody needs it";
}

TEST(DerivativesOfBuffers, AreSeenInOlderModules) {
  Module module = moduleOf(mainWith("color = dFdx(materials.list[2]);"));
  // As compilers spelled it before SPIR-V 1.3: a uniform variable, whose block is a BufferBlock.
  std::uint32_t block = 0;
  for (const Instruction& name : module.names)
    if (name.opcode == spv::Op::OpName && stringOf(name.operands[1]) == "Materials") block = name.word(0);
  ASSERT_NE(block, 0u);
  for (Instruction& annotation : module.annotations)
    if (annotation.opcode == spv::Op::OpDecorate && annotation.word(0) == block && annotation.word(1) == static_cast<std::uint32_t>(spv::Decoration::Block))
      annotation.operands[1] = literalOperand(static_cast<std::uint32_t>(spv::Decoration::BufferBlock));
  for (Instruction& global : module.globals)
    if ((global.opcode == spv::Op::OpTypePointer || global.opcode == spv::Op::OpVariable) &&
        static_cast<spv::StorageClass>(global.word(0)) == spv::StorageClass::StorageBuffer)
      global.operands[0] = literalOperand(static_cast<std::uint32_t>(spv::StorageClass::Uniform));
  const PreparedShader shader = prepareForCaching(module, "main").value();
  EXPECT_TRUE(analyse(shader).derivatives_read_buffers);
}

constexpr const char* kVertex =
    "#version 450\nlayout(location = 0) in vec4 position;\nlayout(location = 0) out vec4 p;\nlayout(location = 1) flat out vec4 whole;\n"
    "void main() { p = position; whole = position; gl_Position = position; }\n";

std::string refusalOf(const std::string& strategy, const std::string& body, bool rejected_lanes_load) {
  const ShaderProgram program = readProgram(compiled(kVertex, "test.vert"), compiled(mainWith(body))).value();
  StateLimits limits{true, true, true};
  limits.rejected_lanes_load = rejected_lanes_load;
  limits.device = "llvmpipe";
  VariantOptions options;
  options.strategy = strategy;
  const auto refusal = refuseVariant(program, {}, options, limits);
  if (refusal && refusal->code == "device.rejected_lanes") {
    EXPECT_NE(refusal->message.find("'llvmpipe'"), std::string::npos) << refusal->message;
  }
  return refusal ? refusal->code : "";
}

TEST(RejectedLanes, RefuseWhatRejectsAPartOfAQuad) {
  const std::string reads = "color = texture(map, p.xy * materials.list[2].xy) * sin(p);", does_not = "color = texture(map, p.xy) * materials.list[2] * sin(p);";
  for (const Strategy& strategy : strategies()) {
    const std::string otherwise = repairs(strategy) ? "repair.derivatives" : "";
    const bool rejects = strategy.selectable && strategy.name != "branch" && !repairs(strategy);
    EXPECT_EQ(refusalOf(strategy.name, reads, false), rejects ? "device.rejected_lanes" : otherwise) << strategy.name;
    EXPECT_EQ(refusalOf(strategy.name, reads, true), otherwise) << strategy.name;
    EXPECT_EQ(refusalOf(strategy.name, does_not, false), otherwise) << strategy.name;
  }
}

// What is built where no device is known says what it needs of the one that plays it.
TEST(RejectedLanes, AreARequirementOfTheRecipe) {
  const ShaderProgram program = readProgram(compiled(kVertex, "test.vert"),
                                            compiled(mainWith("float heavy = sin(exp(p.x)) * cos(p.y); color = texture(map, p.xy * materials.list[2].xy) * heavy;"))).value();
  const std::vector<Candidate> candidates = enumerateCandidates(*program.fragment, program.analysis, program.sources, {});
  ASSERT_TRUE(!candidates.empty() && candidates.front().kept());
  for (const char* strategy : {"branch", "two_pass", "three_pass"}) {
    VariantOptions options;
    options.strategy = strategy;
    const Result<Package> package = buildPackage(program, candidates.front(), options, {true, true, true});
    ASSERT_TRUE(package.ok()) << formatError(package.error());
    EXPECT_EQ(package->variant.requirements.rejected_lanes_load, std::string(strategy) != "branch") << strategy;
    EXPECT_FALSE(package->original.requirements.rejected_lanes_load);
  }
}

TEST(Divergence, IsFoundWhereLanesMayPart) {
  EXPECT_EQ(parted("color = p; if (p.x > 0.5) color = texture(map, p.xy);"), 1u);
  EXPECT_EQ(parted("color = p; if (gl_FragCoord.x > 9.0) color = dFdx(p) + dFdy(p);"), 2u);
  EXPECT_EQ(parted("color = p; for (float t = 0.0; t < p.x; t += 0.1) color += texture(map, p.xy + t);"), 1u) << "lanes leave the loop one by one";
  EXPECT_EQ(parted("color = p; if (p.x > 0.5) { if (scene.tint.x > 0.5) color = fwidth(p); }"), 1u) << "the outer branch parts them";
  EXPECT_EQ(parted("float edge = p.y; if (scene.tint.x > 0.5) edge = p.x; color = p; if (edge > 0.5) color = fwidth(p);"), 1u);
  EXPECT_EQ(parted("color = p; if (texture(map, p.xy).x > 0.5) color = texture(map, p.yx);"), 1u) << "only the second";
  EXPECT_EQ(parted("color = p; if (p.x > 0.5) return; color = fwidth(p);"), 1u);
}

TEST(Divergence, IsNoneWhereQuadsStayTogether) {
  EXPECT_EQ(parted("color = texture(map, p.xy) + dFdx(p);"), 0u);
  EXPECT_EQ(parted("color = p; if (scene.tint.x > 0.5) color = texture(map, p.xy);"), 0u);
  EXPECT_EQ(parted("color = p; if (whole.x > 0.5 && gl_FrontFacing) color = texture(map, p.xy);"), 0u) << "the same for a triangle";
  EXPECT_EQ(parted("color = p; for (int i = 0; i < scene.counts.x; ++i) color += texture(map, p.xy + float(i));"), 0u);
  EXPECT_EQ(parted("vec4 c = p; if (p.x > 0.5) c = p * p; color = c + fwidth(p);"), 0u) << "together again";
  EXPECT_EQ(parted("color = p; if (p.x > 0.5) color = textureLod(map, p.xy, 0.0);"), 0u);
  EXPECT_EQ(parted("color = p; if (p.x > 0.5) { vec4 unused = dFdx(p); color = p.yxwz; }"), 0u) << "nobody needs it";
}

// An alpha test parts nobody, as far as devices go.
TEST(Divergence, IsNotMadeByDiscards) {
  EXPECT_EQ(parted("if (p.x > 0.5) discard; color = texture(map, p.xy);"), 0u);
  EXPECT_EQ(parted("if (texture(map, p.xy).a < 0.5) discard; color = p; if (scene.tint.x > 0.5) color = texture(map, p.yx);"), 0u);
  EXPECT_EQ(parted("if (p.x > 0.5) discard; color = p; if (p.y > 0.5) color = texture(map, p.xy);"), 1u) << "the branch behind it does";
}

TEST(Divergence, NamesTheBranchesThatDecide) {
  const auto shader = analysedMain("vec4 c = p; if (p.z > 0.1) c *= 2.0; if (p.x > 0.5) { if (scene.tint.x > 0.5) c += fwidth(p); } color = c;");
  EXPECT_EQ(shader->analysis.divergence.deciders.size(), 2u) << "not the first, which has nothing to do with it";
}

}  // namespace
}  // namespace reprise
