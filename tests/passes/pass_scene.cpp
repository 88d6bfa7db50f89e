#include "tests/passes/pass_scene.h"

#include "compiler/strategies/build_package.h"
#include "runtime/vulkan/readback.h"

namespace reprise {

VariantOptions asGiven() {
  VariantOptions options;
  options.strategy = "original";
  return options;
}

PassScene::PassScene(const std::vector<std::pair<std::string, std::string>>& files, const std::string& scenario) {
  for (const auto& [name, text] : files) writeText(folder_ / name, text);
  writeText(folder_ / "scene.toml", scenario);
  Result<Subject> read = readSubject(folder_ / "scene.toml");
  REPRISE_CHECK(read.ok(), formatError(read.error()));
  subject_ = std::make_unique<Subject>(std::move(*read));
  ContextOptions options;
  options.validation = true;
  context_ = std::make_unique<Context>(Context::create(options).value());
  commands_ = std::make_unique<Commands>(Commands::create(*context_).value());
  renderer_ = std::make_unique<SceneRenderer>(SceneRenderer::create(*context_, *commands_, subject_->scenario, subject_->program.interface).value());
  const Result<void> passes = renderer_->createPasses(*commands_, package(asGiven()), subject_->passes);
  REPRISE_CHECK(passes.ok(), formatError(passes.error()));
  targets_ = renderer_->createTargets(*commands_).value();
}

Package PassScene::package(const VariantOptions& options) const {
  const Candidate candidate = subject_->candidates.empty() ? Candidate{} : subject_->candidates.front();
  return buildPackage(subject_->program, candidate, options, subject_->limits).value();
}

std::unique_ptr<Player> PassScene::player(const VariantOptions& options) const {
  return std::make_unique<Player>(renderer_->createPlayer(package(options), {}).value());
}

std::vector<float> PassScene::play(Player& player, int frame, std::uint32_t period_frames) {
  const SessionSpec& session = subject_->scenario.sessions.front();
  renderer_->setFrame(session, evaluateFrame(subject_->scenario, session, frame));
  const Result<void> played = commands_->run([&](VkCommandBuffer buffer) -> Result<void> {
    REPRISE_TRY(renderer_->recordPasses(buffer));
    return renderer_->record(buffer, player, targets_, period_frames, {});
  });
  REPRISE_CHECK(played.ok(), formatError(played.error()));
  Readback readback(*context_);
  const auto bytes = readback.read(*commands_, {targets_.colors[0].image.get(), renderer_->colorFormat(0), targets_.extent, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}).value();
  return toFloats(bytes, renderer_->colorFormat(0));
}

std::vector<float> PassScene::original(int frame) {
  const std::unique_ptr<Player> player = this->player(asGiven());
  return play(*player, frame);
}

}  // namespace reprise
