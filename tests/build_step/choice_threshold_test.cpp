// What a build asks for, held against the thresholds that a choice was made under.
#include "cli/choice_threshold.h"

#include <gtest/gtest.h>

#include "profiler/metrics/quality.h"

namespace reprise {
namespace {

Choice madeUnder(const std::vector<Threshold>& thresholds) {
  Choice choice;
  choice.is_original = false;
  choice.limits.thresholds = thresholds;
  return choice;
}

Choice madeUnder(const std::string& quality) { return madeUnder(findQuality(quality)->binding.thresholds); }

DemandWords maxError(double value, const std::string& metric = "") {
  DemandWords words;
  words.max_error = value;
  words.metric = metric;
  return words;
}

DemandWords level(const std::string& quality) {
  DemandWords words;
  words.quality = quality;
  return words;
}

std::string saidOf(const Choice& choice, const DemandWords& words) {
  const Result<void> held = holdThresholds(choice, words, "granite.toml");
  if (held.ok()) return "";
  EXPECT_EQ(held.error().code, "choice.threshold");
  return held.error().message;
}

TEST(ChoiceThreshold, SaysBothNumbersWhereTheChoiceAllowsMore) {
  EXPECT_EQ(saidOf(madeUnder({{"rms", 0.03}}), maxError(0.02)),
            "the choice allows rms 0.03, the build asks for at most 0.02 (--max-error): choose again with 'reprise optimize granite.toml --max-error 0.02'");
}

TEST(ChoiceThreshold, HoldsWhereTheChoiceIsAsStrictOrStricter) {
  EXPECT_EQ(saidOf(madeUnder({{"rms", 0.02}}), maxError(0.02)), "");
  EXPECT_EQ(saidOf(madeUnder({{"blocks", 0.01}, {"rms", 0.01}}), maxError(0.02)), "");
}

TEST(ChoiceThreshold, FailsWhereTheChoiceDoesNotBindTheMetric) {
  const std::string said = saidOf(madeUnder({{"rms", 0.001}}), maxError(0.02, "flip"));
  EXPECT_TRUE(said.starts_with("the choice does not bind flip (it binds rms 0.001), the build asks for at most 0.02 (--max-error)")) << said;
  EXPECT_NE(said.find("--max-error 0.02 --metric flip"), std::string::npos) << said;
}

TEST(ChoiceThreshold, NamesEveryMetricThatFails) {
  DemandWords words;
  words.max = {"tile_flip=0.05", "blocks=0.01", "rms=0.1"};
  const std::string said = saidOf(madeUnder({{"tile_flip", 0.06}, {"rms", 0.1}}), words);
  EXPECT_NE(said.find("tile_flip 0.06, the build asks for at most 0.05 (--max)"), std::string::npos) << said;
  EXPECT_NE(said.find("does not bind blocks"), std::string::npos) << said;
  EXPECT_EQ(said.find("allows rms"), std::string::npos) << said;
  EXPECT_NE(said.find("'reprise optimize granite.toml --max tile_flip=0.05 --max blocks=0.01 --max rms=0.1'"), std::string::npos) << said;
}

TEST(ChoiceThreshold, ALevelHoldsWhereAllOfItsThresholdsAreBoundAsHigh) {
  EXPECT_EQ(saidOf(madeUnder("imperceptible"), level("good")), "");
  EXPECT_EQ(saidOf(madeUnder("good"), level("good")), "");
  EXPECT_NE(saidOf(madeUnder("draft"), level("good")).find("(--quality good)"), std::string::npos);
  EXPECT_NE(saidOf(madeUnder({{"rms", 0.0001}}), level("good")).find("does not bind tile_flip"), std::string::npos);
}

TEST(ChoiceThreshold, AsksNothingWithoutAWord) {
  EXPECT_EQ(saidOf(madeUnder({{"rms", 10}}), {}), "");
}

TEST(ChoiceThreshold, HoldsForTheOriginalWhichHasNoError) {
  Choice choice = madeUnder({{"rms", 10}});
  choice.is_original = true;
  EXPECT_EQ(saidOf(choice, level("imperceptible")), "");
}

TEST(ChoiceThreshold, RefusesWordsThatOptimizeRefuses) {
  const Result<void> held = holdThresholds(madeUnder("good"), level("perfect"), "granite.toml");
  ASSERT_FALSE(held.ok());
  EXPECT_EQ(held.error().code, "quality.unknown");
  DemandWords alone;
  alone.metric = "rms";
  EXPECT_EQ(holdThresholds(madeUnder("good"), alone, "granite.toml").error().code, "metric.alone");
}

}  // namespace
}  // namespace reprise
