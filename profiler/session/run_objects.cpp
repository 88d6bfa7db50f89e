// How many of a frame's objects have misses, as variants that flag their draws see it.
#include <algorithm>

#include "profiler/session/stage.h"

namespace reprise {

Result<JobResult> runObjects(const Job& job, const JobListener& progress) {
  REPRISE_ASSIGN(const std::unique_ptr<Stage> stage, setStage(job));
  REPRISE_ASSIGN(std::deque<Player> players, createPlayers(*stage));
  JobResult result = emptyResult(*stage);
  result.objects.resize(players.size());
  const int session_frames = stage->session->frames > 0 ? stage->session->frames : stage->scenario.frames;
  const int frames = std::min(frameCount(job, *stage), session_frames);
  for (int frame = 0; frame < frames; ++frame) {
    REPRISE_TRY(beginFrame(*stage, frame, job.fence_timeout_s));
    for (std::size_t entry = 0; entry < players.size(); ++entry) {
      Player& player = players[entry];
      const std::uint32_t period = job.entries[entry].period_frames;
      REPRISE_TRY(stage->commands->run([&](VkCommandBuffer buffer) { return stage->renderer->record(buffer, player, stage->targets, period, {}); },
                                       job.fence_timeout_s));
      // In frame 0 everything misses, whatever the variant.
      const std::optional<FlaggedDraws> counted = player.flaggedDraws();
      if (frame == 0 || !counted) continue;
      result.objects[entry].drawn += counted->drawn;
      result.objects[entry].flagged += counted->flagged;
    }
    if (progress) progress({frame + 1, frames});
  }
  return result;
}

}  // namespace reprise
