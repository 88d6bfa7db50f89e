// Which scenarios let the pixels of all their objects be finished in one draw.
#include <gtest/gtest.h>

#include "profiler/scene/shared_inputs.h"

namespace reprise {
namespace {

BlockMember memberNamed(const std::string& name) {
  BlockMember member;
  member.name = name;
  member.rows = member.columns = 4;
  return member;
}

Descriptor blockNamed(const std::string& name, std::uint32_t stages, const std::vector<BlockMember>& members) {
  Descriptor block;
  block.name = name;
  block.stages = stages;
  block.members = members;
  return block;
}

Descriptor textureNamed(const std::string& name) {
  Descriptor texture = blockNamed(name, kStageFragment, {});
  texture.kind = DescriptorKind::kCombinedImageSampler;
  return texture;
}

Scenario withObjects(std::size_t count) {
  Scenario scenario;
  scenario.objects.resize(count);
  scenario.uniforms = {{"Draw.to_world", Semantic::kModel, {}}, {"Scene.eye", Semantic::kCameraPosition, {}}};
  return scenario;
}

bool shares(const Scenario& scenario, const Descriptor& descriptor) {
  ShaderInterface interface;
  interface.descriptors = {descriptor};
  return drawsShareInputs(scenario, interface);
}

TEST(SharedInputs, AreThoseOfOneObjectAndOfBlocksThatHoldNoObject) {
  const Descriptor draw = blockNamed("Draw", kStageVertex | kStageFragment, {memberNamed("to_world")});
  EXPECT_TRUE(shares(withObjects(1), draw));
  EXPECT_FALSE(shares(withObjects(2), draw));
  EXPECT_TRUE(shares(withObjects(2), blockNamed("Scene", kStageFragment, {memberNamed("eye")})));
}

TEST(SharedInputs, MayDifferInWhatTheVertexShaderAloneReads) {
  EXPECT_TRUE(shares(withObjects(2), blockNamed("Draw", kStageVertex, {memberNamed("to_world")})));
}

TEST(SharedInputs, AreNotThoseOfStandardBlocksAndMaterials) {
  EXPECT_FALSE(shares(withObjects(2), blockNamed("StandardObject", kStageFragment, {memberNamed("model")})));
  EXPECT_FALSE(shares(withObjects(2), textureNamed("base_color_map")));
  EXPECT_TRUE(shares(withObjects(2), textureNamed("environment_map")));
  Scenario given = withObjects(2);
  given.textures.emplace_back().name = "base_color_map";
  EXPECT_TRUE(shares(given, textureNamed("base_color_map")));
}

TEST(SharedInputs, AreNotPushConstantsOfAnObject) {
  ShaderInterface interface;
  interface.push_constant_name = "Draw";
  interface.push_constant_members = {memberNamed("to_world")};
  interface.push_constants = {{kStageVertex, 0, 64}};
  EXPECT_TRUE(drawsShareInputs(withObjects(2), interface));
  interface.push_constants = {{kStageVertex | kStageFragment, 0, 64}};
  EXPECT_FALSE(drawsShareInputs(withObjects(2), interface));
}

}  // namespace
}  // namespace reprise
