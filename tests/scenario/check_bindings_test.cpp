// Scenarios against the interface of shaders.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "profiler/scenario/read_scenario.h"

namespace reprise {
namespace {

BlockMember member(const std::string& name, int rows, int columns) {
  BlockMember result;
  result.name = name;
  result.rows = rows;
  result.columns = columns;
  return result;
}

ShaderInterface marbleLike() {
  ShaderInterface interface;
  Descriptor block;
  block.name = "Scene";
  block.members = {member("view_projection", 4, 4), member("gain", 1, 1), member("sun.color", 3, 1)};
  Descriptor texture;
  texture.name = "grain";
  texture.binding = 1;
  texture.kind = DescriptorKind::kCombinedImageSampler;
  texture.dimension = ImageDimension::k2D;
  interface.descriptors = {block, texture};
  interface.push_constant_name = "Object";
  interface.push_constant_members = {member("model", 4, 4)};
  interface.vertex_inputs = {{"position", 0, ScalarKind::kFloat, 3}};
  interface.outputs = {{"color", 0, ScalarKind::kFloat, 4}};
  return interface;
}

Scenario fittingScenario() {
  Scenario scenario;
  scenario.path = "scene.toml";
  scenario.uniforms_place = {"scene.toml", 10, 1};
  scenario.uniforms = {{"Scene.view_projection", Semantic::kViewProjection, {"scene.toml", 11, 1}},
                       {"Scene.gain", Track(FixedTrack{{0.5f}}), {"scene.toml", 12, 1}},
                       {"Scene.sun.color", Track(FixedTrack{{1, 1, 1}}), {"scene.toml", 13, 1}},
                       {"Object.model", Semantic::kModel, {"scene.toml", 14, 1}}};
  TextureSpec texture;
  texture.name = "grain";
  texture.place = {"scene.toml", 20, 1};
  scenario.textures = {texture};
  return scenario;
}

TEST(Bindings, ThatFitAreAccepted) {
  const Result<void> checked = checkBindings(fittingScenario(), marbleLike());
  EXPECT_TRUE(checked.ok()) << formatError(checked.error());
}

struct Misfit {
  std::string name;
  std::function<void(Scenario&, ShaderInterface&)> spoil;
  std::string code;
  int line = 0;
  std::vector<std::string> words;
};

const std::vector<Misfit> kMisfits = {
    {"UniformThatTheShaderLacks",
     [](Scenario& s, ShaderInterface&) { s.uniforms[1].member = "Scene.gian"; },
     "scenario.unknown_uniform",
     12,
     {"'Scene.gian'", "did you mean 'Scene.gain'?"}},
    {"UniformThatNobodyBinds",
     [](Scenario& s, ShaderInterface&) { s.uniforms.erase(s.uniforms.begin() + 1); },
     "scenario.unbound",
     10,
     {"'Scene.gain'"}},
    {"PushConstantThatNobodyBinds",
     [](Scenario& s, ShaderInterface&) { s.uniforms.pop_back(); },
     "scenario.unbound",
     10,
     {"'Object.model'"}},
    {"TooFewNumbers",
     [](Scenario& s, ShaderInterface&) {
       s.uniforms[2].source = Track(FixedTrack{{1, 1}});
     },
     "scenario.value",
     13,
     {"2 numbers", "expected 3", "vec3"}},
    {"TooFewNumbersForAnArray",
     [](Scenario&, ShaderInterface& i) { i.descriptors[0].members[2].array_length = 4; },
     "scenario.value",
     13,
     {"expected 12", "vec3[4]"}},
    {"TooFewNumbersInASession",
     [](Scenario& s, ShaderInterface&) {
       s.sessions.resize(1);
       s.sessions[0].name = "noon";
       s.sessions[0].uniforms["Scene.gain"] = FixedTrack{{1, 2}};
     },
     "scenario.value",
     12,
     {"session 'noon'", "2 numbers"}},
    {"MatrixIntoAFloat",
     [](Scenario& s, ShaderInterface&) { s.uniforms[1].source = Semantic::kModel; },
     "scenario.value",
     12,
     {"'model'", "mat4"}},
    {"TimeIntoAMatrix",
     [](Scenario& s, ShaderInterface&) { s.uniforms[0].source = Semantic::kTime; },
     "scenario.value",
     11,
     {"'time'", "a float"}},
    {"TextureThatTheShaderLacks",
     [](Scenario& s, ShaderInterface&) { s.textures[0].name = "grian"; },
     "scenario.unknown_texture",
     20,
     {"'grian'", "did you mean 'grain'?"}},
    {"TextureThatNobodyGives",
     [](Scenario& s, ShaderInterface&) { s.textures.clear(); },
     "scenario.unbound",
     0,
     {"'grain'"}},
    {"VertexInputThatMeshesLack",
     [](Scenario&, ShaderInterface& i) { i.vertex_inputs[0].name = "positon"; },
     "scenario.vertex_input",
     0,
     {"'positon'", "did you mean 'position'?"}},
    {"IntegerVertexInput",
     [](Scenario&, ShaderInterface& i) { i.vertex_inputs[0].scalar = ScalarKind::kUint; },
     "scenario.vertex_input",
     0,
     {"'position'", "integers"}},
    {"FormatsAndOutputsDiffer",
     [](Scenario& s, ShaderInterface&) {
       s.state.color_formats = {"rgba8_unorm", "rgba8_unorm"};
     },
     "scenario.outputs",
     0,
     {"1 colour output", "2"}},
    {"NoOutput",
     [](Scenario&, ShaderInterface& i) { i.outputs.clear(); },
     "scenario.outputs",
     0,
     {"no colour output"}},
    {"IntegerOutput",
     [](Scenario&, ShaderInterface& i) { i.outputs[0].scalar = ScalarKind::kUint; },
     "scenario.unsupported",
     0,
     {"'color'", "integers"}},
    {"StorageBuffer",
     [](Scenario&, ShaderInterface& i) { i.descriptors[1].kind = DescriptorKind::kStorageBlock; },
     "scenario.unsupported",
     0,
     {"'grain'", "storage buffer"}},
    {"CubeMap",
     [](Scenario&, ShaderInterface& i) { i.descriptors[1].dimension = ImageDimension::kCube; },
     "scenario.unsupported",
     0,
     {"'grain'", "sampler2D"}},
};

class BindingMisfit : public testing::TestWithParam<Misfit> {};

TEST_P(BindingMisfit, IsReported) {
  Scenario scenario = fittingScenario();
  ShaderInterface interface = marbleLike();
  GetParam().spoil(scenario, interface);
  const Result<void> checked = checkBindings(scenario, interface);
  ASSERT_FALSE(checked.ok());
  EXPECT_EQ(checked.error().kind, ErrorKind::kInput);
  // A texture of a kind that cannot be filled is unknown as a texture, too: any of the errors may carry the
  // code.
  const std::string text = formatError(checked.error());
  EXPECT_NE(text.find(GetParam().code), std::string::npos) << text;
  if (GetParam().line > 0) {
    EXPECT_EQ(checked.error().place, (Place{"scene.toml", GetParam().line, 1})) << text;
  }
  for (const std::string& word : GetParam().words)
    EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

INSTANTIATE_TEST_SUITE_P(Misfits, BindingMisfit, testing::ValuesIn(kMisfits),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace reprise
