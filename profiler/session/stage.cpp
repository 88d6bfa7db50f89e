#include "profiler/session/stage.h"

#include "profiler/scenario/read_scenario.h"

namespace reprise {

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
  for (const JobEntry& entry : job.entries) {
    REPRISE_ASSIGN(Package package, readPackage(entry.package_dir));
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
  REPRISE_ASSIGN(stage->targets, stage->renderer->createTargets(*stage->commands));
  return stage;
}

Result<std::deque<Player>> createPlayers(const Stage& stage) {
  std::deque<Player> players;
  for (const Package& package : stage.packages) {
    REPRISE_ASSIGN(Player player, stage.renderer->createPlayer(package, {}));
    if (!player.originalReason().empty())
      return Error{ErrorKind::kMeasurement, "player.requirement", "the variant cannot be played on this device: " + player.originalReason(), {}};
    players.push_back(std::move(player));
  }
  return players;
}

Result<Player> createOriginalPlayer(const Stage& stage) {
  PlayerOptions options;
  options.force_original = true;
  return stage.renderer->createPlayer(stage.original, options);
}

int frameCount(const Job& job, const Stage& stage) {
  if (job.frames > 0) return job.frames;
  return stage.session->frames > 0 ? stage.session->frames : stage.scenario.frames;
}

}  // namespace reprise
