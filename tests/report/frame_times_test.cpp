// Times as training and validation put them together: pairs of eyes, limits, runs at another pace.
#include <gtest/gtest.h>

#include "cli/session_pace.h"
#include "cli/trained.h"

namespace reprise {
namespace {

TEST(FrameTimes, OfAPairOfEyesAreTheirMeanUnderTheRightOne) {
  const std::vector<TimedFrame> pairs = pairedEyes({{1, 9, 9}, {2, 4, 5}, {3, 2, 1}, {4, 8, 8}, {6, 7, 7}, {7, 1, 3}});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].frame, 3);
  EXPECT_EQ(pairs[0].clock_ms, 3);
  EXPECT_EQ(pairs[0].wall_ms, 3);
  EXPECT_EQ(pairs[1].frame, 7);
  EXPECT_EQ(pairs[1].clock_ms, 4);
}

TEST(FrameTimes, NoVariantBeatsTheTailAndOfAPairOneEyeIsTheOriginals) {
  Scenario scenario;
  EXPECT_EQ(limitFrameTime(scenario, 20, 4), 4);
  scenario.stereo.emplace();
  EXPECT_EQ(limitFrameTime(scenario, 20, 4), 12);
}

TEST(FrameTimes, OfALaterRunAreBroughtToThePaceOfTheFirst) {
  const std::vector<TimedFrame> first = {{0, 10, 5}, {1, 12, 6}, {2, 11, 70}}, later = {{0, 20, 6}, {1, 22, 9}, {2, 90, 12}};
  const SessionPace pace = paceAgainst(first, later);
  EXPECT_DOUBLE_EQ(pace.clock, 2);
  EXPECT_DOUBLE_EQ(pace.wall, 1.5);
  const std::vector<TimedFrame> scaled = atPace({{5, 30, 30}}, pace);
  EXPECT_EQ(scaled[0].frame, 5);
  EXPECT_DOUBLE_EQ(scaled[0].clock_ms, 15);
  EXPECT_DOUBLE_EQ(scaled[0].wall_ms, 20);
}

TEST(FrameTimes, KeepTheirPaceWhereARunHasNone) {
  const SessionPace pace = paceAgainst({}, {{0, 20, 6}});
  EXPECT_EQ(pace.clock, 1);
  EXPECT_EQ(pace.wall, 1);
}

}  // namespace
}  // namespace reprise
