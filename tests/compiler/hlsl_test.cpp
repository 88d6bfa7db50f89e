// HLSL through glslang's other front end.
#include <gtest/gtest.h>

#include "compiler/source/compile.h"
#include "compiler/source/reflect.h"
#include "compiler/source/stage_interface.h"

namespace reprise {
namespace {

constexpr const char* kPixel = R"(cbuffer Scene : register(b0) { float4 tint; };
Texture2D albedo_map : register(t0);
SamplerState linear_sampler : register(s0);
struct Input { float4 position : SV_Position; float3 place : TEXCOORD0; float2 uv : TEXCOORD1; };
float4 PSMain(Input input) : SV_Target0 {
  float3 albedo = albedo_map.Sample(linear_sampler, input.uv).rgb;
  return float4(albedo * tint.rgb * input.place, 1);
}
float4 Other(Input input) : SV_Target0 { return 1; }
)";

CompileOptions optionsFor(const std::string& entry_point) {
  CompileOptions options;
  options.entry_point = entry_point;
  return options;
}

TEST(Hlsl, IsKnownByItsSuffixAndTakesTheNamedEntryPoint) {
  const auto shader = compileText(kPixel, "test.ps.hlsl", optionsFor("PSMain"));
  ASSERT_TRUE(shader.ok()) << formatError(shader.error());
  EXPECT_EQ(shader->stage, ShaderStage::kFragment);
  EXPECT_EQ(reflectStage(shader->words, ShaderStage::kFragment)->descriptors.size(), 3u);
  const auto other = compileText(kPixel, "test.ps.hlsl", optionsFor("Other"));
  ASSERT_TRUE(other.ok()) << formatError(other.error());
  EXPECT_TRUE(reflectStage(other->words, ShaderStage::kFragment)->descriptors.empty());
}

TEST(Hlsl, RegistersOfEveryKindGetBindingsOfTheirOwn) {
  const auto shader = compileText(kPixel, "test.ps.hlsl", optionsFor("PSMain"));
  ASSERT_TRUE(shader.ok()) << formatError(shader.error());
  const auto stage = reflectStage(shader->words, ShaderStage::kFragment);
  ASSERT_TRUE(stage.ok()) << formatError(stage.error());
  const auto bindingOf = [&](DescriptorKind kind) {
    for (const Descriptor& descriptor : stage->descriptors)
      if (descriptor.kind == kind) return descriptor.binding;
    return 999u;
  };
  EXPECT_EQ(bindingOf(DescriptorKind::kUniformBlock), 0u);
  EXPECT_EQ(bindingOf(DescriptorKind::kSampledImage), 16u);
  EXPECT_EQ(bindingOf(DescriptorKind::kSampler), 32u);
}

TEST(Hlsl, VertexInputsAreCalledAsMeshesCallThem) {
  const auto shader = compileText("struct Input { float3 position : POSITION; float2 uv : TEXCOORD0; };\n"
                                  "float4 VSMain(Input input) : SV_Position { return float4(input.position, input.uv.x); }\n",
                                  "test.vs.hlsl", optionsFor("VSMain"));
  ASSERT_TRUE(shader.ok()) << formatError(shader.error());
  const auto stage = reflectStage(shader->words, ShaderStage::kVertex);
  ASSERT_TRUE(stage.ok()) << formatError(stage.error());
  ASSERT_EQ(stage->vertex_inputs.size(), 2u);
  EXPECT_EQ(stage->vertex_inputs[0].name, "position");
  EXPECT_EQ(stage->vertex_inputs[1].name, "uv");
}

TEST(Hlsl, ErrorsHaveLines) {
  std::string text = kPixel;
  text.replace(text.find("albedo * tint"), 6, "albido");
  const auto shader = compileText(text, "test.ps.hlsl", optionsFor("PSMain"));
  ASSERT_FALSE(shader.ok());
  EXPECT_EQ(shader.error().code, "source.syntax");
  EXPECT_EQ(shader.error().place.line, 7);
  EXPECT_NE(shader.error().message.find("albido"), std::string::npos);
}

TEST(Hlsl, AMissingEntryPointIsSaid) {
  const auto shader = compileText(kPixel, "test.ps.hlsl", optionsFor("NoSuchThing"));
  ASSERT_FALSE(shader.ok());
  EXPECT_EQ(shader.error().kind, ErrorKind::kInput);
}

TEST(Hlsl, DefinesAndMatrixSemanticsWork) {
  CompileOptions options = optionsFor("PSMain");
  options.defines = {{"GAIN", "2.0"}};
  const auto shader = compileText("cbuffer C { float4x4 turn; };\nfloat4 PSMain(float4 p : TEXCOORD0) : SV_Target0 { return mul(turn, p) * GAIN; }\n",
                                  "test.ps.hlsl", options);
  EXPECT_TRUE(shader.ok()) << formatError(shader.error());
}

}  // namespace
}  // namespace reprise
