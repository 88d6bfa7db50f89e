#include "profiler/session/stage.h"

#include <cstring>

#include "profiler/scenario/names.h"
#include "profiler/scenario/read_scenario.h"

namespace reprise {
namespace {

Result<std::vector<Package>> readPasses(const Scenario& scenario) {
  std::vector<Package> packages(scenario.passes.size());
  for (std::size_t pass = 0; pass < packages.size(); ++pass) {
    const PassSpec& spec = scenario.passes[pass];
    if (spec.kind == ScenePassKind::kShadow) continue;
    if (spec.package.empty())
      return Error{ErrorKind::kInput, "session.pass", "the pass '" + spec.name + "' has no 'package': its shaders are compiled by 'reprise optimize', which "
                   "leaves a scenario with them in its output directory", spec.place};
    REPRISE_ASSIGN(packages[pass], readPackage(spec.package));
  }
  return packages;
}

void chooseFormats(JobKind kind, Stage& stage) {
  const std::size_t outputs = stage.original.interface.outputs.size();
  std::vector<std::string>& formats = stage.scenario.state.color_formats;
  stage.given_formats = formats;
  stage.given_formats.resize(outputs, kColorFormats[0]);
  if (kind == JobKind::kProbe || kind == JobKind::kReference || kind == JobKind::kLaws) formats.assign(outputs, "rgba32_sfloat");
}

}  // namespace

Result<std::unique_ptr<Stage>> setStage(const Job& job) {
  auto stage = std::make_unique<Stage>();
  REPRISE_ASSIGN(stage->scenario, readScenario(job.scenario_path));
  if (job.width > 0) stage->scenario.width = job.width;
  if (job.height > 0) stage->scenario.height = job.height;
  for (const SessionSpec& session : stage->scenario.sessions)
    if (session.name == job.session) stage->session = &session;
  if (stage->session == nullptr)
    return Error{ErrorKind::kInput, "session.unknown", "the scenario has no session '" + job.session + "'", {job.scenario_path, 0, 0}};
  REPRISE_ASSIGN(stage->original, readPackage(job.original_dir));
  REPRISE_ASSIGN(stage->passes, readPasses(stage->scenario));
  std::vector<ShaderInterface> pass_interfaces;
  for (const Package& pass : stage->passes) pass_interfaces.push_back(pass.interface);
  REPRISE_TRY(checkBindings(stage->scenario, stage->original.interface, pass_interfaces));
  chooseFormats(job.kind, *stage);
  for (const JobEntry& entry : job.entries) {
    REPRISE_ASSIGN(Package package, readPackage(entry.package_dir));
    if (package.interface != stage->original.interface)
      return Error{ErrorKind::kInput, "job.interface",
                   "the package '" + entry.package_dir + "' was made from other shaders than the original in '" + job.original_dir + "'", {}};
    stage->packages.push_back(std::move(package));
  }
  ContextOptions options;
  options.device = job.device;
  REPRISE_ASSIGN(Context context, Context::create(options));
  stage->context = std::make_unique<Context>(std::move(context));
  REPRISE_ASSIGN(Commands commands, Commands::create(*stage->context));
  stage->commands = std::make_unique<Commands>(std::move(commands));
  REPRISE_ASSIGN(SceneRenderer renderer, SceneRenderer::create(*stage->context, *stage->commands, stage->scenario, stage->original.interface));
  stage->renderer = std::make_unique<SceneRenderer>(std::move(renderer));
  REPRISE_TRY(stage->renderer->createPasses(*stage->commands, stage->original, stage->passes));
  REPRISE_ASSIGN(stage->targets, stage->renderer->createTargets(*stage->commands));
  return stage;
}

Result<void> beginFrame(Stage& stage, int frame, double timeout_s) {
  stage.renderer->setFrame(*stage.session, evaluateFrame(stage.scenario, *stage.session, frame));
  if (!stage.renderer->hasPasses()) return {};
  return stage.commands->run([&](VkCommandBuffer buffer) { return stage.renderer->recordPasses(buffer); }, timeout_s);
}

Result<Player> createPlayer(const Stage& stage, const Package& package) {
  PlayerOptions options;
  options.frames_in_flight = 1;  // every frame is waited for
  REPRISE_ASSIGN(Player player, stage.renderer->createPlayer(package, options));
  if (!player.originalReason().empty())
    return Error{ErrorKind::kMeasurement, "player.requirement", "the variant cannot be played on this device: " + player.originalReason(), {}};
  return player;
}

Result<std::deque<Player>> createPlayers(const Stage& stage) {
  std::deque<Player> players;
  for (const Package& package : stage.packages) {
    REPRISE_ASSIGN(Player player, createPlayer(stage, package));
    players.push_back(std::move(player));
  }
  return players;
}

Result<Player> createOriginalPlayer(const Stage& stage) {
  PlayerOptions options;
  options.force_original = true;
  return stage.renderer->createPlayer(stage.original, options);
}

Result<std::vector<std::uint8_t>> coveredPixels(const Stage& stage, Readback& readback) {
  // D32_SFLOAT names the depth of images with stencil, too.
  REPRISE_ASSIGN(const auto texels, readback.read(*stage.commands, {stage.targets.depth.image.get(), VK_FORMAT_D32_SFLOAT, stage.targets.extent,
                                                                    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL}));
  const float clear_depth = stage.renderer->clearDepth();
  std::vector<std::uint8_t> covered(texels.size() / 4);
  for (std::size_t pixel = 0; pixel < covered.size(); ++pixel) {
    float depth;
    std::memcpy(&depth, &texels[pixel * 4], sizeof depth);
    covered[pixel] = depth != clear_depth ? 1 : 0;
  }
  return covered;
}

std::vector<float> payloadFloats(std::span<const std::byte> bytes, VkFormat format, const PayloadValue& payload) {
  if (!payload.type.starts_with("i")) return toFloats(bytes, format);
  switch (format) {
    case VK_FORMAT_R32_UINT: return toFloats(bytes, VK_FORMAT_R32_SINT);
    case VK_FORMAT_R32G32_UINT: return toFloats(bytes, VK_FORMAT_R32G32_SINT);
    case VK_FORMAT_R32G32B32A32_UINT: return toFloats(bytes, VK_FORMAT_R32G32B32A32_SINT);
    default: return toFloats(bytes, format);
  }
}

JobResult emptyResult(const Stage& stage) {
  JobResult result;
  const DeviceSummary& device = stage.context->summary();
  result.device = device.name;
  result.driver = device.driver;
  result.cpu_device = device.is_cpu;
  return result;
}

int frameCount(const Job& job, const Stage& stage) {
  if (job.frames > 0) return job.frames;
  return stage.session->frames > 0 ? stage.session->frames : stage.scenario.frames;
}

}  // namespace reprise
