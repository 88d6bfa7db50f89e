#include "profiler/scene/track.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace reprise {
namespace {

float valueAt(const Track& track, double time_s) {
  return evaluateTrack(track, time_s, 1).at(0);
}

TEST(KeyFrames, AreLinearBetweenAndClampedOutside) {
  const Track track = KeyFramesTrack{{1, 3, 4}, {{10}, {20}, {0}}};
  EXPECT_EQ(valueAt(track, 0), 10);
  EXPECT_EQ(valueAt(track, 1), 10);
  EXPECT_FLOAT_EQ(valueAt(track, 1.5), 12.5f);
  EXPECT_FLOAT_EQ(valueAt(track, 3), 20);
  EXPECT_FLOAT_EQ(valueAt(track, 3.75), 5);
  EXPECT_EQ(valueAt(track, 4), 0);
  EXPECT_EQ(valueAt(track, 1000), 0);
}

TEST(KeyFrames, OfOneAreConstant) {
  const Track track = KeyFramesTrack{{1}, {{7}}};
  EXPECT_EQ(valueAt(track, 0), 7);
  EXPECT_EQ(valueAt(track, 2), 7);
}

TEST(Oscillation, SwingsAboutItsBase) {
  const Track track = OscillationTrack{{1, 0}, {2, 5}, 4, 0};
  EXPECT_NEAR(valueAt(track, 0), 1, 1e-6);
  EXPECT_NEAR(valueAt(track, 1), 3, 1e-6);
  EXPECT_NEAR(valueAt(track, 3), -1, 1e-6);
  EXPECT_NEAR(valueAt(track, 5), valueAt(track, 1), 1e-6);
  EXPECT_NEAR(evaluateTrack(track, 1, 1).at(1), 5, 1e-6);
}

RandomWalkTrack anyWalk() {
  RandomWalkTrack walk;
  walk.base = {static_cast<float>(*rc::gen::inRange(-10, 10)), 2};
  walk.extent = {static_cast<float>(*rc::gen::inRange(0, 5)), 0.25f};
  walk.step_per_s = static_cast<float>(*rc::gen::inRange(0, 40));
  walk.seed = *rc::gen::arbitrary<std::uint32_t>();
  return walk;
}

RC_GTEST_PROP(RandomWalk, StaysWithinItsBounds, ()) {
  const RandomWalkTrack walk = anyWalk();
  for (int frame = 0; frame < 300; ++frame) {
    const std::vector<float> values = evaluateTrack(walk, frame / 30.0, 1);
    for (std::size_t i = 0; i < 2; ++i) {
      RC_ASSERT(values[i] >= walk.base[i] - walk.extent[i]);
      RC_ASSERT(values[i] <= walk.base[i] + walk.extent[i]);
    }
  }
}

RC_GTEST_PROP(RandomWalk, StartsAtItsBase, ()) {
  const RandomWalkTrack walk = anyWalk();
  RC_ASSERT(evaluateTrack(walk, 0, 1) == walk.base);
}

RC_GTEST_PROP(RandomWalk, IsNoFasterThanItsStep, ()) {
  const RandomWalkTrack walk = anyWalk();
  std::vector<float> before = walk.base;
  for (int frame = 1; frame < 300; ++frame) {
    const std::vector<float> values = evaluateTrack(walk, frame / 60.0, 1);
    for (std::size_t i = 0; i < 2; ++i)
      RC_ASSERT(std::abs(values[i] - before[i]) <= walk.step_per_s / 60 + 1e-5f);
    before = values;
  }
}

TEST(RandomWalk, IsAFunctionOfTimeAndSeedsAlone) {
  RandomWalkTrack walk{{0, 0}, {3, 3}, 2, 5};
  const std::vector<float> later = evaluateTrack(walk, 7.3, 1);
  evaluateTrack(walk, 2, 1);
  EXPECT_EQ(evaluateTrack(walk, 7.3, 1), later);
  EXPECT_NE(evaluateTrack(walk, 7.3, 2), later) << "the scenario's seed has no effect";
  walk.seed = 6;
  EXPECT_NE(evaluateTrack(walk, 7.3, 1), later) << "the walk's seed has no effect";
}

TEST(RandomWalk, MovesItsComponentsApart) {
  const std::vector<float> values = evaluateTrack(RandomWalkTrack{{0, 0}, {3, 3}, 2, 5}, 7.3, 1);
  EXPECT_NE(values[0], values[1]);
}

TEST(RandomWalk, Moves) {
  const RandomWalkTrack walk{{0}, {3}, 2, 5};
  double travelled = 0;
  for (int frame = 1; frame <= 600; ++frame)
    travelled += std::abs(valueAt(walk, frame / 60.0) - valueAt(walk, (frame - 1) / 60.0));
  EXPECT_GT(travelled, 2) << "in ten seconds at up to 2 a second";
}

}  // namespace
}  // namespace reprise
