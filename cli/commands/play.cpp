#include "cli/commands/play.h"

#include <fmt/format.h>

#include <filesystem>

#include "profiler/scenario/read_scenario.h"
#include "profiler/session/display.h"
#include "profiler/session/stage.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

struct PlayedFrame {
  std::string hash;
  bool counted = false;
  std::uint64_t hits = 0, misses = 0;
};

Result<Job> jobOf(const PlayArguments& arguments) {
  Job job;
  const fs::path directory = arguments.directory;
  const bool is_output = fs::is_directory(directory / "package");
  job.original_dir = (is_output ? directory / "package" : directory).string();
  job.scenario_path = arguments.scenario;
  if (job.scenario_path.empty()) {
    const fs::path beside = directory / "scenario" / "scenario.toml";
    if (!fs::exists(beside))
      return Error{ErrorKind::kUsage, "play.scenario",
                   "there is no " + beside.string() + "; say what to play the package in, with --scenario FILE", {}};
    job.scenario_path = beside.string();
  }
  job.session = arguments.session;
  if (job.session.empty()) {
    REPRISE_ASSIGN(const Scenario scenario, readScenario(job.scenario_path));
    for (const SessionSpec& session : scenario.sessions)
      if (job.session.empty() && session.role == SessionRole::kValidation) job.session = session.name;
    if (job.session.empty()) job.session = scenario.sessions.front().name;
  }
  job.frames = arguments.frames;
  job.device = arguments.device;
  return job;
}

class Playback {
 public:
  Playback(Stage& stage, const std::string& png_dir) : stage_(stage), readback_(*stage.context), png_dir_(png_dir) {}

  Result<PlayedFrame> play(Player& player, int frame, std::uint32_t period_frames) {
    REPRISE_TRY(beginFrame(stage_, frame));
    REPRISE_TRY(stage_.commands->run(
        [&](VkCommandBuffer buffer) { return stage_.renderer->record(buffer, player, stage_.targets, period_frames, {}); }));
    PlayedFrame played;
    std::string hashes;
    for (std::size_t i = 0; i < stage_.targets.colors.size(); ++i) {
      REPRISE_ASSIGN(const auto texels, readColor(i));
      hashes += contentHash({reinterpret_cast<const char*>(texels.data()), texels.size()});
      if (i == 0 && !png_dir_.empty()) REPRISE_TRY(writeFrame(texels, frame));
    }
    played.hash = stage_.targets.colors.size() == 1 ? hashes : contentHash(hashes);
    REPRISE_TRY(count(player, played));
    return played;
  }

 private:
  Result<std::span<const std::byte>> readColor(std::size_t target) {
    return readback_.read(*stage_.commands, {stage_.targets.colors[target].image.get(), stage_.renderer->colorFormat(target),
                                             stage_.targets.extent, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL});
  }

  Result<void> writeFrame(std::span<const std::byte> texels, int frame) {
    DisplayImage image{static_cast<int>(stage_.scenario.width), static_cast<int>(stage_.scenario.height), {}};
    toDisplay(texels, stage_.renderer->colorFormat(0), {stage_.scenario.tone_map, stage_.scenario.exposure}, image, nullptr);
    return writePng(image, fs::path(png_dir_) / fmt::format("frame_{:04}.png", frame));
  }

  Result<void> count(const Player& player, PlayedFrame& played) {
    const auto kind = player.resource("kind");
    if (!kind) return {};
    REPRISE_ASSIGN(const auto kinds, readback_.read(*stage_.commands, {kind->image, kind->format, kind->extent, kind->layout}));
    played.counted = true;
    for (const std::byte one : kinds) {
      played.hits += one == std::byte{1};
      played.misses += one == std::byte{2};
    }
    return {};
  }

  Stage& stage_;
  Readback readback_;
  std::string png_dir_;
};

void printFrame(int frame, const PlayedFrame& played, std::ostream& out) {
  out << fmt::format("frame {:>4}  {}", frame, played.hash);
  if (played.counted) out << fmt::format("  hits {:>8}  misses {:>8}", played.hits, played.misses);
  out << "\n";
}

}  // namespace

Result<void> playPackage(const PlayArguments& arguments, std::ostream& out) {
  REPRISE_ASSIGN(const Job job, jobOf(arguments));
  REPRISE_ASSIGN(const std::unique_ptr<Stage> stage, setStage(job));
  PlayerOptions options;
  options.force_original = arguments.original;
  REPRISE_ASSIGN(Player player, stage->renderer->createPlayer(stage->original, options));
  const std::uint32_t period_frames = arguments.period_frames.value_or(player.recipe().period_frames);
  const int count = frameCount(job, *stage);
  out << fmt::format("'{}', session '{}', {} frames on {}\n", player.recipe().strategy, stage->session->name, count,
                     stage->context->summary().name);
  if (!player.originalReason().empty()) out << "the original is played: " << player.originalReason() << "\n";
  Playback playback(*stage, arguments.png_dir);
  for (int frame = 0; frame < count; ++frame) {
    REPRISE_ASSIGN(const PlayedFrame played, playback.play(player, frame, period_frames));
    if (arguments.hashes) printFrame(frame, played, out);
  }
  if (!arguments.png_dir.empty()) out << "frames: " << arguments.png_dir << "\n";
  return {};
}

}  // namespace reprise
