#include <gtest/gtest.h>

#include <set>

#include "runtime/package/recipe.h"

namespace reprise {
namespace {

constexpr std::uint32_t kWidth = 640, kHeight = 360;

TEST(RefreshGroup, MakesEveryPixelDueExactlyOnceInAPeriod) {
  for (const PatternKind kind : kPatternKinds)
    for (std::uint32_t period = 1; period <= 64; period *= 2)
      for (std::uint32_t y = 0; y < kHeight; y += 13)
        for (std::uint32_t x = 0; x < kWidth; x += 11)
          ASSERT_LT(refreshGroup(kind, x, y, period, 8, kWidth, kHeight), period) << nameOf(kind) << " " << x << "," << y;
}

TEST(RefreshGroup, IsTheSameForAllPixelsOfABlock) {
  for (const PatternKind kind : kPatternKinds)
    for (std::uint32_t y = 0; y < kHeight; y += 3)
      for (std::uint32_t x = 0; x < kWidth; x += 3)
        ASSERT_EQ(refreshGroup(kind, x, y, 16, 8, kWidth, kHeight), refreshGroup(kind, x / 8 * 8, y / 8 * 8, 16, 8, kWidth, kHeight));
}

TEST(RefreshGroup, UsesAllGroupsOfPatternsThatSpreadTheWork) {
  for (const PatternKind kind : kPatternKinds) {
    if (kind == PatternKind::kWhole) continue;
    std::set<std::uint32_t> groups;
    for (std::uint32_t y = 0; y < kHeight; y += 16)
      for (std::uint32_t x = 0; x < kWidth; x += 16) groups.insert(refreshGroup(kind, x, y, 16, 16, kWidth, kHeight));
    EXPECT_EQ(groups.size(), 16u) << nameOf(kind);
  }
}

TEST(RefreshGroup, WholeMakesEveryPixelDueInEveryNthFrameAndIsKnownWithoutAPixel) {
  const Refresh whole{PatternKind::kWhole, 2, 16};
  for (std::uint32_t frame = 0; frame < 6; ++frame) {
    EXPECT_EQ(isWhollyDue(whole, frame), frame % 2 == 0) << frame;
    EXPECT_EQ(isDue(dueBlocks(whole, frame, kWidth, kHeight), whole, 639, 7), frame % 2 == 0) << frame;
  }
  EXPECT_FALSE(isWhollyDue({PatternKind::kWhole, kNeverRefresh, 16}, 0));
  EXPECT_FALSE(isWhollyDue({PatternKind::kInterleaved, 2, 16}, 0));
}

}  // namespace
}  // namespace reprise
