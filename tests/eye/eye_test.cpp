// The levels of quality in scenes where blocks are easy to see: what each allows orders as it should, and does not depend on how dark the frame is.
//
// Of each scene the best candidate that draft allows at all is played at every period in a validation session. The longest period that a level's thresholds allow is
// what it allows. Pictures of it lie in tests/eye of the build folder, for a person to look at: original.png, and cached_i.png for the levels from
// the strictest (a level that allows no period is left out).
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/open_bench.h"
#include "cli/probe_candidates.h"
#include "cli/train.h"
#include "profiler/metrics/quality.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

const std::vector<std::uint32_t> kPeriods = {2, 4, 8, 16};
constexpr std::size_t kCandidates = 6;

class EyeScene {
 public:
  EyeScene(const std::string& scenario, const std::string& name)
      : folder_(fs::path(REPRISE_EYE_PICTURES) / name), subject_(readSubject(std::string(REPRISE_SOURCE_DIR) + "/tests/eye/" + scenario).value()) {
    fs::remove_all(folder_);
    workspace_ = Workspace::open(folder_.string()).value();
    EXPECT_TRUE(copyInputs(subject_, workspace_.scenarioFile()).ok());
    std::erase_if(subject_.candidates, [](const Candidate& candidate) { return !candidate.kept(); });
    subject_.candidates.resize(std::min(kCandidates, subject_.candidates.size()));
    bench_ = std::make_unique<Bench>(openBench(subject_, workspace_, {"", REPRISE_EXECUTABLE, {"tile_flip"}, {}}, chosenDevice("").value()).value());
    bench_->measuring.store = &bench_->store;
    for (const SessionSpec& session : subject_.scenario.sessions)
      if (session.role == SessionRole::kValidation && session_.empty()) session_ = session.name;
    Progress quiet(ProgressStyle::kQuiet);
    const ProbedRanges probed = probeCandidates(subject_, workspace_, bench_->measuring, quiet).value();
    for (const auto& [candidate, ranges] : probed.ranges) {
      measure(candidate, ranges);
      if (longestAllowed(qualities().back()) > 1) break;
    }
  }

  // For a reader of a failure.
  std::string table() const {
    std::string text;
    for (std::size_t i = 0; i < kPeriods.size(); ++i) {
      text += "period " + std::to_string(kPeriods[i]) + ":";
      for (const Threshold& threshold : qualities().front().binding.thresholds)
        text += " " + threshold.metric + " " + std::to_string(sessionError(threshold.metric, {&series_[i].rows}, kPeriods[i]).value_or(-1));
      text += "\n";
    }
    return text;
  }

  // 1 where it allows none.
  std::uint32_t longestAllowed(const Quality& quality) const {
    std::uint32_t longest = 1;
    for (std::size_t i = 0; i < kPeriods.size(); ++i) {
      const std::optional<double> share = sessionError(quality.binding, {&series_[i].rows}, kPeriods[i]);
      EXPECT_TRUE(share.has_value());
      if (share && *share <= 1) longest = std::max(longest, kPeriods[i]);
    }
    return longest;
  }

  void writePictures() const {
    Job job;
    job.kind = JobKind::kImages;
    job.scenario_path = bench_->measuring.scenario_path;
    job.session = session_;
    job.original_dir = bench_->measuring.original_dir;
    job.image_frame = 39;
    job.image_dir = folder_.string();
    for (const Quality& quality : qualities())
      if (const std::uint32_t period = longestAllowed(quality); period > 1) job.entries.push_back({variant_.dir, period});
    if (job.entries.empty()) return;
    const Result<JobResult> made = superviseJob(job, bench_->measuring.supervisor, {});
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : formatError(made.error()));
  }

 private:
  void measure(std::size_t candidate, const ValueRanges& ranges) {
    VariantOptions options = baseOptions(subject_, ranges, subject_.candidates[candidate]);
    options.strategy = "two_pass";
    options.instrumented = options.aged = true;
    variant_ = storeVariant(workspace_, subject_.program, subject_.candidates[candidate], options, subject_.limits).value();
    std::vector<SeriesRequest> requests;
    for (const std::uint32_t period : kPeriods) requests.push_back({variant_.dir, variant_.hash, period});
    series_ = measureErrors(bench_->measuring, session_, requests, 0).value();
  }

  fs::path folder_;
  Subject subject_;
  Workspace workspace_;
  std::unique_ptr<Bench> bench_;
  std::string session_;
  StoredVariant variant_;
  std::vector<ErrorSeries> series_;
};

class EyeLevels : public testing::TestWithParam<const char*> {};

TEST_P(EyeLevels, StricterLevelsAllowShorterPeriods) {
  const EyeScene scene(std::string(GetParam()) + "/scenario.toml", GetParam());
  std::uint32_t last = 1;
  for (const Quality& quality : qualities()) {
    const std::uint32_t longest = scene.longestAllowed(quality);
    EXPECT_GE(longest, last) << quality.name << "\n" << scene.table();
    last = longest;
  }
  EXPECT_GT(last, 1u) << "draft allows nothing, so this says nothing\n" << scene.table();
  scene.writePictures();
}

// Nothing hides a seam there: at period 16 a brick pattern is plain to see, at 4 there is none.
TEST(Eye, SeesTheSeamsOfAFlatSurface) {
  const EyeScene scene("grey/scenario.toml", "grey_seams");
  EXPECT_LE(scene.longestAllowed(*findQuality("imperceptible")), 4u) << scene.table();
  EXPECT_LE(scene.longestAllowed(*findQuality("good")), 8u) << scene.table();
  EXPECT_GE(scene.longestAllowed(*findQuality("good")), 4u) << scene.table();
}

INSTANTIATE_TEST_SUITE_P(Scenes, EyeLevels, testing::Values("ball", "grey", "night"), [](const auto& scene) { return std::string(scene.param); });

// Tiles brighter than mid-grey are not adapted, so the highlights of the rock are judged a little stricter in full light: by a step of the period at
// most. By rms alone the dark rock is allowed errors four times as large for its light.
TEST(Eye, JudgesARockInAQuarterOfTheLightAsTheRock) {
  const EyeScene rock("rock/scenario.toml", "rock"), quarter("rock/rock_quarter.toml", "rock_quarter");
  std::uint32_t last = 1;
  for (const Quality& quality : qualities()) {
    const std::uint32_t bright = rock.longestAllowed(quality), dark = quarter.longestAllowed(quality);
    EXPECT_LE(std::max(bright, dark), 2 * std::min(bright, dark)) << quality.name << "\n" << rock.table() << "\n" << quarter.table();
    EXPECT_GE(bright, last) << quality.name;
    last = bright;
  }
  rock.writePictures();
  quarter.writePictures();
}

}  // namespace
}  // namespace reprise
