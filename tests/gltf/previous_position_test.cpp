// Where a vertex was in the last frame, by the rewritten vertex shader, against the scene posed on the CPU at that time.
//
// The variant's fragment shader is replaced by one that shows the previous position and the vertex's number, both flat: each triangle
// then shows those of its first vertex, not interpolated.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <set>

#include "cli/subject.h"
#include "cli/train.h"
#include "compiler/strategies/build_package.h"
#include "profiler/scenario/read_models.h"
#include "profiler/session/scene_renderer.h"
#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/readback.h"
#include "tests/gltf/made_gltf.h"

namespace reprise {
namespace {

constexpr int kFrame = 20;
constexpr float kHalfViewport = 128;

const char* kFragment = R"(#version 450
layout(location = 0) in vec4 color;
layout(location = 1) in vec3 object_position;
layout(location = 0) out vec4 out_color;
void main() {
  vec3 sum = vec3(0);
  for (int i = 1; i < 9; ++i) sum += sin(object_position * float(i) + color.rgb) / float(i);
  out_color = vec4(sum, 1);
}
)";

// The previous position is at the first location that is free, 2, in pixels of the viewport times w (glsl/previous_position.vert).
const char* kWitness = R"(#version 450
layout(location = 0) flat in vec4 color;
layout(location = 2) flat in vec3 previous;
layout(location = 0) out vec4 out_color;
void main() { out_color = vec4(previous, color.r + 1.0); }
)";

const char* kScenario = R"(
[shader]
fragment = "a.frag"
[render]
width = 256
height = 256
frames = 24
cull = "none"
formats = ["rgba32_sfloat"]
[[model]]
name = "bar"
file = "made.gltf"
motion = { translate = { oscillate = { base = [0, 0, 0], amplitude = [0.3, 0.1, 0], period_s = 1 } }, spin_rad_per_frame = 0.02 }
[[session]]
name = "train"
role = "training"
camera = { orbit = { target = [0, 0.5, 0], radius = 2.5, radians_per_frame = 0.02 } }
[[session]]
name = "check"
role = "validation"
camera = { eye = [0, 1, 4], target = [0, 0, 0] }
)";

struct Witnessed {
  glm::vec3 previous;  // clip x, y, w
  std::size_t vertex;
};

class PreviousPosition : public testing::TestWithParam<MadeParts> {
 protected:
  void SetUp() override {
    folder_.write("a.frag", kFragment);
    folder_.write("made.gltf", madeGltf(GetParam()).dump());
    const Result<Subject> read = readSubject(folder_.write("scene.toml", kScenario));
    ASSERT_TRUE(read.ok()) << formatError(read.error());
    subject_ = std::make_unique<Subject>(*read);
    context_ = std::make_unique<Context>(Context::create({}).value());
    commands_ = std::make_unique<Commands>(Commands::create(*context_).value());
    renderer_ = std::make_unique<SceneRenderer>(SceneRenderer::create(*context_, *commands_, subject_->scenario, subject_->program.interface).value());
    targets_ = renderer_->createTargets(*commands_).value();
  }

  Package witness() const {
    VariantOptions options = baseOptions(*subject_, {});
    options.strategy = "branch";
    Package package = buildPackage(subject_->program, subject_->candidates.front(), options, subject_->limits).value();
    CompileOptions compiling;
    compiling.stage = ShaderStage::kFragment;
    const std::vector<std::uint32_t> words = compileText(kWitness, "witness.frag", compiling).value().words;
    for (const Pass& pass : package.variant.passes) package.modules[pass.fragment_module] = words;
    return package;
  }

  void play(Player& player, int frame) {
    const SessionSpec& session = subject_->scenario.sessions.front();
    renderer_->setFrame(session, evaluateFrame(subject_->scenario, session, frame));
    ASSERT_TRUE(commands_->run([&](VkCommandBuffer buffer) { return renderer_->record(buffer, player, targets_, 4, {}); }).ok());
  }

  std::vector<Witnessed> shown() {
    Readback readback(*context_);
    const auto bytes = readback.read(*commands_, {targets_.colors[0].image.get(), renderer_->colorFormat(0), targets_.extent, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}).value();
    std::vector<Witnessed> witnessed;
    for (std::size_t at = 0; at + 16 <= bytes.size(); at += 16) {
      float texel[4];
      std::memcpy(texel, &bytes[at], 16);
      // The background's alpha is 1 as that of vertex 0 is, which begins a triangle but is told by no other mark: left out.
      if (texel[3] > 1.5f) witnessed.push_back({{texel[0] / kHalfViewport - texel[2], texel[1] / kHalfViewport - texel[2], texel[2]}, static_cast<std::size_t>(std::lround(texel[3] - 1))});
    }
    return witnessed;
  }

  glm::vec3 reference(std::size_t number, int frame) const {
    const Scenario& scenario = subject_->scenario;
    const FrameState state = evaluateFrame(scenario, scenario.sessions.front(), frame);
    const GltfScene& scene = *scenario.models[0].scene;
    const GltfPrimitive& primitive = scene.meshes[0].primitives[0];
    for (std::size_t v = 0; v < primitive.vertices.size(); ++v) {
      if (std::lround(primitive.vertices[v].color[0]) != static_cast<long>(number)) continue;
      const glm::vec4 clip = state.projection * state.view * state.placements[0] * glm::vec4(positionAt(scene, state.poses[0], scene.instances[0], v), 1);
      return {clip.x, clip.y, clip.w};
    }
    return glm::vec3(NAN);
  }

  ModelFolder folder_;
  std::unique_ptr<Subject> subject_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Commands> commands_;
  std::unique_ptr<SceneRenderer> renderer_;
  RenderTargets targets_;
};

TEST_P(PreviousPosition, IsThatOfTheLastFrameForEveryVertex) {
  Player player = renderer_->createPlayer(witness(), {}).value();
  ASSERT_EQ(player.originalReason(), "");
  play(player, kFrame);
  play(player, kFrame + 1);
  std::set<std::size_t> seen;
  float moved = 0;
  for (const Witnessed& witnessed : shown()) {
    const glm::vec3 wanted = reference(witnessed.vertex, kFrame);
    EXPECT_LT(glm::distance(witnessed.previous, wanted), 1e-5f) << "vertex " << witnessed.vertex;
    moved = std::max(moved, glm::distance(reference(witnessed.vertex, kFrame + 1), wanted));
    seen.insert(witnessed.vertex);
  }
  EXPECT_GE(seen.size(), 10u);
  EXPECT_GT(moved, 1e-2f);
}

INSTANTIATE_TEST_SUITE_P(Kinds, PreviousPosition,
                         testing::Values(MadeParts{false, false}, MadeParts{true, false}, MadeParts{false, true}, MadeParts{true, true},
                                         MadeParts{true, true, true, "CUBICSPLINE"}),
                         [](const auto& each) {
                           return std::string(each.param.skinned ? "Skinned" : "") + (each.param.morphed ? "Morphed" : "") + "Moved" + each.param.interpolation;
                         });

}  // namespace
}  // namespace reprise
