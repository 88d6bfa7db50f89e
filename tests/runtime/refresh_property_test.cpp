// The refresh pattern for any size, period and block: every pixel is due once in a period, in whole blocks.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "runtime/package/recipe.h"

namespace reprise {
namespace {

struct Target {
  PatternKind pattern;
  std::uint32_t period, block, width, height;

  std::uint32_t groupAt(std::uint32_t x, std::uint32_t y) const {
    return refreshGroup(pattern, x, y, period, block, width, height);
  }
};

Target anyTarget() {
  return {*rc::gen::element(PatternKind::kTiled, PatternKind::kRandom, PatternKind::kInterleaved, PatternKind::kWhole),
          1u << *rc::gen::inRange(0, 7), 1u << *rc::gen::inRange(1, 6), *rc::gen::inRange<std::uint32_t>(1, 700),
          *rc::gen::inRange<std::uint32_t>(1, 500)};
}

RC_GTEST_PROP(RefreshProperty, EveryPixelIsDueOnceInAPeriod, ()) {
  const Target target = anyTarget();
  const auto x = *rc::gen::inRange<std::uint32_t>(0, target.width), y = *rc::gen::inRange<std::uint32_t>(0, target.height);
  int due = 0;
  for (std::uint32_t frame = 1000; frame < 1000 + target.period; ++frame) due += target.groupAt(x, y) == frame % target.period;
  RC_ASSERT(due == 1);
}

RC_GTEST_PROP(RefreshProperty, AGroupIsTheSameForAWholeEvenAlignedBlock, ()) {
  const Target target = anyTarget();
  const auto x = *rc::gen::inRange<std::uint32_t>(0, target.width), y = *rc::gen::inRange<std::uint32_t>(0, target.height);
  const std::uint32_t first_x = x - x % target.block, first_y = y - y % target.block;
  RC_ASSERT(first_x % 2 == 0 && first_y % 2 == 0);
  RC_ASSERT(target.groupAt(x, y) == target.groupAt(first_x, first_y));
  RC_ASSERT(target.groupAt(x, y) == target.groupAt(first_x + target.block - 1, first_y + target.block - 1));
}

TEST(RefreshProperty, RandomSpreadsTheWorkEvenly) {
  const Target target{PatternKind::kRandom, 8, 8, 1280, 720};
  std::map<std::uint32_t, int> blocks;
  for (std::uint32_t y = 0; y < target.height; y += 8)
    for (std::uint32_t x = 0; x < target.width; x += 8) ++blocks[target.groupAt(x, y)];
  ASSERT_EQ(blocks.size(), 8u);
  // 14,400 blocks: 1,800 in each group, with a standard deviation of 40.
  for (const auto& [group, count] : blocks) EXPECT_NEAR(count, 1800, 200) << group;
}

TEST(RefreshProperty, InterleavedNeighboursAreNeverDueTogether) {
  const Target target{PatternKind::kInterleaved, 4, 16, 640, 360};
  EXPECT_NE(target.groupAt(0, 0), target.groupAt(16, 0));
  EXPECT_NE(target.groupAt(0, 0), target.groupAt(0, 16));
  EXPECT_EQ(target.groupAt(0, 0), target.groupAt(32, 32));
}

TEST(RefreshProperty, TiledGroupsAreRectangles) {
  const Target target{PatternKind::kTiled, 4, 16, 640, 352};
  EXPECT_EQ(target.groupAt(0, 0), target.groupAt(319, 175));
  EXPECT_NE(target.groupAt(319, 0), target.groupAt(320, 0));
  EXPECT_NE(target.groupAt(0, 175), target.groupAt(0, 176));
}

// What the player uploads selects the very pixels of the group.
RC_GTEST_PROP(RefreshProperty, DueBlocksAreTheGroupOfTheFrame, ()) {
  const Target target = anyTarget();
  const auto x = *rc::gen::inRange<std::uint32_t>(0, target.width), y = *rc::gen::inRange<std::uint32_t>(0, target.height);
  const auto frame = *rc::gen::inRange<std::uint32_t>(0, 1000);
  const Refresh refresh{target.pattern, target.period, target.block};
  const DueBlocks due = dueBlocks(refresh, frame, target.width, target.height);
  RC_ASSERT(isDue(due, refresh, x, y) == (target.groupAt(x, y) == frame % target.period));
}

RC_GTEST_PROP(RefreshProperty, NeverIsNeverDue, ()) {
  const Target target = anyTarget();
  const auto x = *rc::gen::inRange<std::uint32_t>(0, target.width), y = *rc::gen::inRange<std::uint32_t>(0, target.height);
  const Refresh refresh{target.pattern, kNeverRefresh, target.block};
  RC_ASSERT(!isDue(dueBlocks(refresh, *rc::gen::inRange<std::uint32_t>(0, 1000), target.width, target.height), refresh, x, y));
}

TEST(RefreshPropertyDeathTest, NeverHasNoGroups) {
  EXPECT_EXIT(refreshGroup(PatternKind::kTiled, 0, 0, kNeverRefresh, 8, 64, 64), testing::ExitedWithCode(70), "period_frames");
}

}  // namespace
}  // namespace reprise
