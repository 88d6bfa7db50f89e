#include "profiler/session/gbuffer_pass.h"

#include <algorithm>

#include "profiler/session/scene_renderer.h"

namespace reprise {
namespace {

// The scenario as the pass draws it.
Scenario scenarioOf(const PassParts& parts, const ShaderInterface& interface) {
  Scenario scenario = *parts.scenario;
  scenario.state.color_formats.clear();
  for (const PassOutput& output : scenario.passes[parts.pass].outputs) scenario.state.color_formats.push_back(output.format);
  scenario.state.depth_stencil = false;
  scenario.state.clear = {0, 0, 0, 0};
  std::erase_if(scenario.textures, [&](const TextureSpec& texture) {
    return std::none_of(interface.descriptors.begin(), interface.descriptors.end(), [&](const Descriptor& descriptor) { return descriptor.name == texture.name; });
  });
  return scenario;
}

class GBufferPass final : public ScenePass {
 public:
  GBufferPass(const PassParts& parts, const Package& package)
      : device_(parts.context->view()), interface_(package.interface), scenario_(scenarioOf(parts, interface_)), textures_(parts.textures), pass_(parts.pass) {}

  Result<void> create(const PassParts& parts, const Package& package) {
    REPRISE_ASSIGN(SceneRenderer renderer, SceneRenderer::create(*parts.context, *parts.commands, {&scenario_, &interface_, textures_}));
    renderer_ = std::make_unique<SceneRenderer>(std::move(renderer));
    PlayerOptions options;
    options.frames_in_flight = 1;
    options.force_original = true;
    REPRISE_ASSIGN(Player player, renderer_->createPlayer(package, options));
    player_ = std::make_unique<Player>(std::move(player));
    return {};
  }

  void setFrame(const SessionSpec& session, const FrameState& state) override { renderer_->setFrame(session, state); }

  Result<void> record(VkCommandBuffer commands) override {
    const RenderTargets& targets = textures_->targets[pass_];
    beginWriting(device_, commands, targets);
    REPRISE_TRY(renderer_->record(commands, *player_, targets, 1, {}));
    endWriting(device_, commands, targets);
    return {};
  }

 private:
  const DeviceView& device_;
  ShaderInterface interface_;
  Scenario scenario_;
  std::shared_ptr<const PassTextures> textures_;
  std::size_t pass_;
  std::unique_ptr<SceneRenderer> renderer_;
  std::unique_ptr<Player> player_;
};

}  // namespace

Result<std::unique_ptr<ScenePass>> createGBufferPass(const PassParts& parts, const Package& package) {
  auto pass = std::make_unique<GBufferPass>(parts, package);
  REPRISE_TRY(pass->create(parts, package));
  return std::unique_ptr<ScenePass>(std::move(pass));
}

}  // namespace reprise
