// Jobs that compare packages with the original: what is right passes in every strategy, and what is wrong is told with its place.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

#include "compiler/strategies/registry.h"
#include "profiler/session/law_frames.h"
#include "tests/session/measured_scene.h"
#include "tests/session/spoiled_package.h"

namespace reprise {
namespace {

TEST(LawFrames, AreEightInPairsFromEvenOnesOn) {
  EXPECT_EQ(lawFrames(9), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(lawFrames(12), (std::vector<int>{0, 1, 2, 3, 6, 7, 10, 11}));
  EXPECT_EQ(lawFrames(101), (std::vector<int>{0, 1, 32, 33, 66, 67, 98, 99}));
  EXPECT_EQ(frozenFrame(101), 66);
}

TEST(LawFrames, AreAllOfAShortSession) {
  EXPECT_EQ(lawFrames(8), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(lawFrames(3), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(lawFrames(1), (std::vector<int>{0}));
  EXPECT_EQ(frozenFrame(1), 0);
  EXPECT_EQ(frozenFrame(3), 0);
}

TEST(LawFrames, LieWithinTheSession) {
  for (int frames = 1; frames < 300; ++frames) {
    const std::vector<int> chosen = lawFrames(frames);
    EXPECT_EQ(chosen.size(), static_cast<std::size_t>(std::min(frames, 8)));
    EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    EXPECT_EQ(std::adjacent_find(chosen.begin(), chosen.end()), chosen.end()) << frames;
    EXPECT_LT(chosen.back(), frames);
    EXPECT_TRUE(std::find(chosen.begin(), chosen.end(), frozenFrame(frames)) != chosen.end()) << frames;
  }
}

VariantOptions lawCopy(const std::string& strategy) {
  VariantOptions options = countingVariant();
  options.strategy = strategy;
  options.encoding = Encoding::kRgba32f;
  options.filter = Filter::kNearest;
  return options;
}

class LawsJob : public testing::Test {
 protected:
  LawOutcome outcomeOf(const std::string& package_dir, const MeasuredScene& scene, std::uint32_t period = 4) const {
    Job job = scene.job(JobKind::kLaws, {package_dir, period});
    job.reference_dir = (scene.folder() / "reference").string();
    std::filesystem::create_directories(job.reference_dir);
    Job reference = job;
    reference.kind = JobKind::kReference;
    reference.entries.clear();
    const Result<JobResult> original = runJob(reference, {});
    EXPECT_TRUE(original.ok()) << formatError(original.error());
    const Result<JobResult> result = runJob(job, {});
    EXPECT_TRUE(result.ok()) << formatError(result.error());
    return result.ok() ? result->laws.at(0) : LawOutcome{};
  }

  std::string spoiled(const std::string& module) const {
    const std::string right = scene_.variant("right", lawCopy("two_pass"), "base"), wrong = (scene_.folder() / ("wrong_" + module)).string();
    spoilPackage(right, wrong, module, 0.7f, 0.9f);
    return wrong;
  }

  // Its light, which hits and misses compute, has the constant 0.7.
  MeasuredScene scene_{"shaders/laws/straight_line/straight_line.toml"};
};

TEST_F(LawsJob, FindsNoDifferenceInAnyStrategy) {
  for (const Strategy& strategy : strategies()) {
    if (!strategy.selectable || strategy.needs_stencil || flagsDraws(strategy) || repairs(strategy)) continue;
    const LawOutcome outcome = outcomeOf(scene_.variant(strategy.name, lawCopy(strategy.name)), scene_);
    EXPECT_FALSE(outcome.difference) << strategy.name << ", pixel " << outcome.difference->x << ", " << outcome.difference->y;
    EXPECT_FALSE(outcome.rounding) << strategy.name;
    EXPECT_GT(outcome.frozen_hits, 0u) << strategy.name;
  }
}

TEST_F(LawsJob, FindsNoDifferenceWhereAgesAreTold) {
  VariantOptions aged = lawCopy("two_pass");
  aged.aged = true;
  const LawOutcome outcome = outcomeOf(scene_.variant("aged", aged), scene_);
  EXPECT_FALSE(outcome.difference);
  EXPECT_FALSE(outcome.rounding);
  EXPECT_GT(outcome.frozen_hits, 0u);
}

TEST_F(LawsJob, TellsWhereMissesAreWrong) {
  const LawOutcome outcome = outcomeOf(spoiled("fragment_misses"), scene_);
  ASSERT_TRUE(outcome.difference);
  const LawDifference& difference = *outcome.difference;
  EXPECT_EQ(difference.law, kExactSetting);
  EXPECT_EQ(difference.frame, 0);
  EXPECT_EQ(difference.output, 0);
  EXPECT_EQ(difference.kind, 2);
  EXPECT_LT(difference.x, 96u);
  EXPECT_LT(difference.y, 64u);
  EXPECT_GT(difference.pixels, 0u);
  EXPECT_TRUE(difference.visible);
  double largest = 0;
  for (std::size_t channel = 0; channel < 4; ++channel)
    largest = std::max(largest, static_cast<double>(std::abs(std::bit_cast<float>(difference.expected[channel]) - std::bit_cast<float>(difference.found[channel]))));
  EXPECT_GT(largest, 1e-2);
}

TEST_F(LawsJob, TellsWhereHitsAreWrongThoughAllMissesAreRight) {
  const LawOutcome outcome = outcomeOf(spoiled("fragment_hits"), scene_);
  ASSERT_TRUE(outcome.difference);
  EXPECT_EQ(outcome.difference->law, kFrozenWorld);
  EXPECT_EQ(outcome.difference->kind, 1);
  EXPECT_EQ(outcome.difference->frame, frozenFrame(12));
}

TEST_F(LawsJob, LooksAtTheExactSettingAloneAtPeriodOne) {
  const LawOutcome outcome = outcomeOf(spoiled("fragment_hits"), scene_, 1);
  EXPECT_FALSE(outcome.difference);
  EXPECT_EQ(outcome.frozen_hits, 0u);
}

// 0.35 becomes its neighbour: off by a few units in the last place, which 8 bits may show or not.
TEST_F(LawsJob, TellsRoundingFromMore) {
  const std::string right = scene_.variant("right", lawCopy("branch"), "base"), wrong = (scene_.folder() / "rounded").string();
  spoilPackage(right, wrong, "fragment_branch", 0.35f, std::nextafter(0.35f, 1.0f));
  const LawOutcome outcome = outcomeOf(wrong, scene_);
  EXPECT_FALSE(outcome.difference);
  EXPECT_TRUE(outcome.rounding);
}

TEST_F(LawsJob, ComparesNothingWithFramesOfAnotherSize) {
  outcomeOf(scene_.variant("right", lawCopy("branch")), scene_);
  Job job = scene_.job(JobKind::kLaws, {scene_.variant("right", lawCopy("branch")), 4});
  job.reference_dir = (scene_.folder() / "reference").string();
  job.width = 128;
  const Result<JobResult> result = runJob(job, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "job.reference");
}

}  // namespace
}  // namespace reprise
