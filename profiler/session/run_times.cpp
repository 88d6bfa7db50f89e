// Frame times: in every round each entry renders the same frame in a submission of its own; the order turns round by round, so
// that nobody always goes first. Nothing is read back.
#include <ctime>

#include <algorithm>
#include <chrono>

#include "profiler/session/stage.h"

namespace reprise {
namespace {

double processSeconds() {
  std::timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

Result<Handle<VkQueryPool>> createTimestamps(const DeviceView& device, std::uint32_t count) {
  VkQueryPoolCreateInfo create{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  create.queryType = VK_QUERY_TYPE_TIMESTAMP;
  create.queryCount = count;
  VkQueryPool pool = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateQueryPool(device.device, &create, nullptr, &pool));
  return Handle<VkQueryPool>(device.device, pool, device.fn.vkDestroyQueryPool);
}

class TimeRun {
 public:
  TimeRun(const Job& job, Stage& stage) : job_(job), stage_(stage) {}

  Result<JobResult> run(const JobListener& progress) {
    REPRISE_ASSIGN(std::deque<Player> players, createPlayers(stage_));
    std::size_t most_passes = 1;
    for (const Player& player : players) most_passes = std::max(most_passes, player.recipe().passes.size());
    if (stage_.context->has_timestamps()) {
      REPRISE_ASSIGN(timestamps_, createTimestamps(stage_.context->view(), static_cast<std::uint32_t>(most_passes) + 1));
    }
    JobResult result = emptyResult(stage_);
    result.times.resize(players.size());
    const int total = job_.warmup_frames + job_.rounds;
    for (int round = 0; round < total; ++round) {
      REPRISE_TRY(beginFrame(stage_, round, job_.fence_timeout_s));
      for (std::size_t i = 0; i < players.size(); ++i) {
        const std::size_t entry = round % 2 == 0 ? i : players.size() - 1 - i;
        REPRISE_ASSIGN(TimeRow row, timeFrame(players[entry], job_.entries[entry].period_frames));
        if (round < job_.warmup_frames) continue;
        row.run_id = job_.run_id;
        row.pair = round - job_.warmup_frames;
        row.frame = round;
        result.times[entry].push_back(std::move(row));
      }
      if (progress) progress({round + 1, total});
    }
    return result;
  }

 private:
  Result<TimeRow> timeFrame(Player& player, std::uint32_t period) {
    REPRISE_TRY(stage_.commands->record(
        [&](VkCommandBuffer buffer) { return stage_.renderer->record(buffer, player, stage_.targets, period, {timestamps_.get()}); }));
    TimeRow row;
    const double cpu_before = processSeconds();
    const auto wall_before = std::chrono::steady_clock::now();
    REPRISE_TRY(stage_.commands->submitAndWait(job_.fence_timeout_s));
    row.wall_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - wall_before).count();
    row.cpu_ms = (processSeconds() - cpu_before) * 1e3;
    if (timestamps_) {
      const DeviceView& device = stage_.context->view();
      const auto count = static_cast<std::uint32_t>(player.recipe().passes.size()) + 1;
      std::vector<std::uint64_t> ticks(count);
      REPRISE_VK(device.fn.vkGetQueryPoolResults(device.device, timestamps_.get(), 0, count, count * 8, ticks.data(), 8,
                                                 VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT));
      row.gpu_ms = static_cast<double>(ticks.back() - ticks.front()) * stage_.context->timestamp_period_ns() * 1e-6;
    }
    return row;
  }

  const Job& job_;
  Stage& stage_;
  Handle<VkQueryPool> timestamps_;
};

}  // namespace

Result<JobResult> runTimes(const Job& job, const JobListener& progress) {
  REPRISE_ASSIGN(const std::unique_ptr<Stage> stage, setStage(job));
  return TimeRun(job, *stage).run(progress);
}

}  // namespace reprise
