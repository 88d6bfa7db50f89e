// Laws 1 and 3 on the scenario's own inputs: what a package draws at its exact setting, and while its scene is frozen, against what the
// original drew. The original is played by a job of its own, in a process that plays nothing else, and leaves its colours in files.
#include <algorithm>
#include <cstring>
#include <fstream>

#include "profiler/metrics/rounding.h"
#include "profiler/scenario/names.h"
#include "profiler/session/law_frames.h"
#include "profiler/session/read_kinds.h"
#include "profiler/session/stage.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

constexpr int kFrozenFrames = 4;  // the first misses everywhere

using Words = std::vector<std::uint32_t>;

struct Played {
  std::vector<Words> colors;        // by output, bits of RGBA floats
  std::vector<std::uint8_t> kinds;  // empty where the package does not count
};

Words wordsOf(std::span<const std::byte> bytes) {
  Words words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

// Whether a later pass of the frame reads the payload back, so that misses too see it as it is kept.
bool readsPayloadBack(const Recipe& recipe) {
  for (const Pass& pass : recipe.passes)
    for (const Read& read : pass.reads)
      if (read.current && read.resource == payloadTarget(0)) return true;
  return false;
}

class FramePlayer {
 public:
  FramePlayer(const Job& job, Stage& stage) : job_(job), stage_(stage), readback_(*stage.context) {}

  Result<Played> play(Player& player, int frame, std::uint32_t period_frames) {
    REPRISE_TRY(beginFrame(stage_, frame, job_.fence_timeout_s));
    REPRISE_TRY(stage_.commands->run([&](VkCommandBuffer buffer) { return stage_.renderer->record(buffer, player, stage_.targets, period_frames, {}); },
                                     job_.fence_timeout_s));
    Played played;
    for (const Image& image : stage_.targets.colors) {
      REPRISE_ASSIGN(const auto texels, readback_.read(*stage_.commands, {image.image.get(), image.format, stage_.targets.extent,
                                                                          VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}));
      played.colors.push_back(wordsOf(texels));
    }
    REPRISE_ASSIGN(PixelKinds told, readKinds(readback_, *stage_.commands, player));
    played.kinds = std::move(told.kind);
    return played;
  }

 private:
  const Job& job_;
  Stage& stage_;
  Readback readback_;
};

Result<void> writeColors(const std::string& directory, int frame, const Played& played) {
  for (std::size_t output = 0; output < played.colors.size(); ++output) {
    const std::filesystem::path file = referenceFile(directory, frame, output);
    const std::string_view bytes = bytesOf(played.colors[output]);
    // Read by the next job and deleted: nothing that must outlive a power failure.
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) return Error{ErrorKind::kMachine, "file.unwritable", "cannot write '" + file.string() + "'", {}};
  }
  return {};
}

class LawRun {
 public:
  LawRun(const Job& job, Stage& stage) : job_(job), stage_(stage), frames_(frameCount(job, stage)), player_(job, stage) {}

  Result<JobResult> run(const JobListener& progress) {
    JobResult result = emptyResult(stage_);
    progress_.total = static_cast<int>(stage_.packages.size() * (lawFrames(frames_).size() + kFrozenFrames));
    for (std::size_t entry = 0; entry < stage_.packages.size(); ++entry) {
      REPRISE_ASSIGN(LawOutcome outcome, runEntry(entry, progress));
      result.laws.push_back(std::move(outcome));
    }
    return result;
  }

 private:
  Result<LawOutcome> runEntry(std::size_t entry, const JobListener& progress) {
    const JobEntry& asked = job_.entries[entry];
    REPRISE_ASSIGN(Player player, createPlayer(stage_, stage_.packages[entry]));
    LawOutcome outcome;
    const auto play = [&](const char* law, int frame, std::uint32_t period, double tolerance) -> Result<void> {
      if (outcome.difference) return {};
      REPRISE_ASSIGN(const Played played, player_.play(player, frame, period));
      if (law == std::string_view(kFrozenWorld)) outcome.frozen_hits += static_cast<std::uint64_t>(std::count(played.kinds.begin(), played.kinds.end(), 1));
      ++progress_.done;
      if (progress) progress(progress_);
      return compare(law, frame, played, tolerance, outcome);
    };
    const double at_misses = readsPayloadBack(player.recipe()) ? asked.tolerance : 0;
    for (const int frame : lawFrames(frames_)) REPRISE_TRY(play(kExactSetting, frame, 1, at_misses));
    if (asked.period_frames == 1) return outcome;
    player.invalidate();
    for (int i = 0; i < kFrozenFrames; ++i) REPRISE_TRY(play(kFrozenWorld, frozenFrame(frames_), asked.period_frames, asked.tolerance));
    return outcome;
  }

  Result<void> compare(const char* law, int frame, const Played& played, double tolerance, LawOutcome& outcome) const {
    for (std::size_t output = 0; output < played.colors.size(); ++output) {
      const std::filesystem::path file = referenceFile(job_.reference_dir, frame, output);
      REPRISE_ASSIGN(const Words expected, readWords(file, kMostFrameBytes));
      if (expected.size() != played.colors[output].size())
        return Error{ErrorKind::kInput, "job.reference", "'" + file.string() + "' is of another size than the frames that are compared with it", {}};
      compareOutput({law, frame, output, tolerance}, expected, played, outcome);
      if (outcome.difference) return {};
    }
    return {};
  }

  struct Comparison {
    const char* law;
    int frame;
    std::size_t output;
    double tolerance;
  };

  void compareOutput(const Comparison& comparison, const Words& expected, const Played& played, LawOutcome& outcome) const {
    const Words& found = played.colors[comparison.output];
    const bool tolerated = comparison.tolerance > 0;
    const RoundingVerdict verdict = compareImages({expected, found, ChannelKind::kFloat}, tolerated ? comparison.tolerance : kRoundingTolerance);
    if (verdict.nearness == Nearness::kEqual || (tolerated && verdict.nearness == Nearness::kRounded)) return;
    bool rounding = verdict.nearness == Nearness::kRounded, visible = true;
    if (stage_.given_formats[comparison.output] == kColorFormats[0]) {
      const Nearness of_bytes = compareImages({unorm8Of(expected), unorm8Of(found), ChannelKind::kUnorm8}).nearness;
      rounding = rounding || of_bytes != Nearness::kBeyond;
      visible = of_bytes != Nearness::kEqual;
    }
    std::optional<LawDifference>& kept = rounding ? outcome.rounding : outcome.difference;
    if (!kept || (rounding && visible && !kept->visible)) kept = describe(comparison, verdict, expected, played, visible);
  }

  LawDifference describe(const Comparison& comparison, const RoundingVerdict& verdict, const Words& expected, const Played& played, bool visible) const {
    LawDifference difference;
    difference.law = comparison.law;
    difference.frame = comparison.frame;
    difference.output = static_cast<int>(comparison.output);
    difference.x = static_cast<std::uint32_t>(verdict.pixel % stage_.targets.extent.width);
    difference.y = static_cast<std::uint32_t>(verdict.pixel / stage_.targets.extent.width);
    std::copy_n(&expected[verdict.pixel * 4], 4, difference.expected.begin());
    std::copy_n(&played.colors[comparison.output][verdict.pixel * 4], 4, difference.found.begin());
    if (!played.kinds.empty()) difference.kind = played.kinds[verdict.pixel];
    difference.pixels = verdict.differing;
    difference.visible = visible;
    return difference;
  }

  const Job& job_;
  Stage& stage_;
  int frames_;
  FramePlayer player_;
  JobProgress progress_;
};

}  // namespace

Result<JobResult> runReference(const Job& job, const JobListener& progress) {
  REPRISE_ASSIGN(const std::unique_ptr<Stage> stage, setStage(job));
  REPRISE_ASSIGN(Player original, createOriginalPlayer(*stage));
  FramePlayer player(job, *stage);
  const std::vector<int> frames = lawFrames(frameCount(job, *stage));
  JobProgress state{0, static_cast<int>(frames.size())};
  for (const int frame : frames) {
    REPRISE_ASSIGN(const Played played, player.play(original, frame, 1));
    REPRISE_TRY(writeColors(job.reference_dir, frame, played));
    ++state.done;
    if (progress) progress(state);
  }
  return emptyResult(*stage);
}

Result<JobResult> runLaws(const Job& job, const JobListener& progress) {
  REPRISE_ASSIGN(const std::unique_ptr<Stage> stage, setStage(job));
  return LawRun(job, *stage).run(progress);
}

}  // namespace reprise
