// What the laws say of frames that are made by hand.
#include "cli/check/frame_laws.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace reprise {
namespace {

constexpr std::uint32_t kClear = 0x3f800000u, kNear = 0x3f000000u;  // 1.0f, 0.5f

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

// Three pixels: nothing, a hit, a miss.
HarnessFrame frameOf(float hit, float miss) {
  HarnessFrame frame;
  frame.depth = {kClear, kNear, kNear};
  frame.kind = {0, 1, 2};
  frame.colors = {{0, 0, 0, 0, bits(hit), 0, 0, 0, bits(miss), 0, 0, 0}};
  return frame;
}

ColorLaw lawOf(ExactPixels pixels, double tolerance = 0) { return {"law.test", pixels, tolerance}; }

TEST(FrameLaws, EqualFramesBreakNone) {
  EXPECT_FALSE(findViolation(frameOf(1, 2), frameOf(1, 2), lawOf(ExactPixels::kAll)));
}

TEST(FrameLaws, AHitMayDifferWhereOnlyMissesAreExact) {
  EXPECT_FALSE(findViolation(frameOf(1, 2), frameOf(1.5f, 2), lawOf(ExactPixels::kMisses)));
  const auto violation = findViolation(frameOf(1, 2), frameOf(1.5f, 2), lawOf(ExactPixels::kAll));
  ASSERT_TRUE(violation);
  EXPECT_EQ(violation->law, "law.test");
  EXPECT_EQ(violation->pixel, 1u);
}

TEST(FrameLaws, AMissIsExactToTheBit) {
  const float next = std::nextafter(2.0f, 3.0f);
  const auto violation = findViolation(frameOf(1, 2), frameOf(1, next), lawOf(ExactPixels::kMisses));
  ASSERT_TRUE(violation);
  EXPECT_EQ(violation->pixel, 2u);
  EXPECT_FALSE(findViolation(frameOf(1, 2), frameOf(1, next), lawOf(ExactPixels::kMisses, 1e-5)));
}

TEST(FrameLaws, OneNanIsAsGoodAsAnother) {
  const float quiet = std::numeric_limits<float>::quiet_NaN();
  HarnessFrame other = frameOf(quiet, 2);
  other.colors[0][4] ^= 1;
  EXPECT_FALSE(findViolation(frameOf(quiet, 2), other, lawOf(ExactPixels::kAll)));
  EXPECT_TRUE(findViolation(frameOf(quiet, 2), frameOf(1, 2), lawOf(ExactPixels::kAll, 1e-5)));
}

TEST(FrameLaws, DepthIsTheOriginals) {
  HarnessFrame other = frameOf(1, 2);
  ++other.depth[1];
  const auto violation = findViolation(frameOf(1, 2), other, lawOf(ExactPixels::kMisses));
  ASSERT_TRUE(violation);
  EXPECT_EQ(violation->law, "law.depth");
}

TEST(FrameLaws, WhatIsDrawnIsAHitOrAMiss) {
  HarnessFrame lost = frameOf(1, 2), invented = frameOf(1, 2);
  lost.kind[2] = 0;
  invented.kind[0] = 1;
  EXPECT_EQ(findViolation(frameOf(1, 2), lost, lawOf(ExactPixels::kAll))->law, "law.books");
  EXPECT_EQ(findViolation(frameOf(1, 2), invented, lawOf(ExactPixels::kAll))->law, "law.books");
}

TEST(FrameLaws, ComputedDepthMayBeRounded) {
  HarnessFrame other = frameOf(1, 2);
  ++other.depth[1];
  ColorLaw law = lawOf(ExactPixels::kAll, 1e-5);
  EXPECT_TRUE(findViolation(frameOf(1, 2), other, law));
  law.computed_depth = true;
  EXPECT_FALSE(findViolation(frameOf(1, 2), other, law));
  law.tolerance = 0;
  EXPECT_TRUE(findViolation(frameOf(1, 2), other, law));
}

TEST(FrameLaws, EarlyTestsLeaveDepthOfWhatIsDiscarded) {
  HarnessFrame discarded = frameOf(1, 2), invented = frameOf(1, 2);
  discarded.kind[2] = 0;
  invented.kind[0] = 1;
  ColorLaw law = lawOf(ExactPixels::kAll);
  law.depth_tells_coverage = false;
  EXPECT_FALSE(findViolation(frameOf(1, 2), discarded, law));
  EXPECT_TRUE(findViolation(frameOf(1, 2), invented, law));
}

TEST(FrameLaws, PixelsLeftOutAreCountedButNotCompared) {
  const std::vector<bool> left_out = {false, true, false};
  ColorLaw law = lawOf(ExactPixels::kAll);
  law.left_out = &left_out;
  EXPECT_FALSE(findViolation(frameOf(1, 2), frameOf(1.5f, 2), law));
  EXPECT_TRUE(findViolation(frameOf(1, 2), frameOf(1, 2.5f), law));
  HarnessFrame lost = frameOf(1, 2);
  lost.kind[1] = 0;
  EXPECT_EQ(findViolation(frameOf(1, 2), lost, law)->law, "law.books");
}

TEST(MeaninglessInputs, AreToldWithTheReason) {
  const std::vector<FragmentOutput> outputs = {{"color", 0, ScalarKind::kFloat, 4}};
  EXPECT_EQ(meaningOf(frameOf(1, 2), outputs).shows, Showing::kVaries);
  const Meaning constant = meaningOf(frameOf(2, 2), outputs);
  EXPECT_EQ(constant.shows, Showing::kConstant);
  EXPECT_NE(constant.why.find("the same"), std::string::npos);
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_NE(meaningOf(frameOf(infinite, infinite), outputs).why.find("not finite"), std::string::npos);
  const std::vector<bool> left_out = {false, true, true};
  EXPECT_NE(meaningOf(frameOf(1, 2), outputs, &left_out).why.find("covers 0"), std::string::npos) << "nothing would be compared";
  HarnessFrame empty = frameOf(1, 2);
  empty.depth = {kClear, kClear, kClear};
  EXPECT_NE(meaningOf(empty, outputs).why.find("covers 0"), std::string::npos);
}

}  // namespace
}  // namespace reprise
