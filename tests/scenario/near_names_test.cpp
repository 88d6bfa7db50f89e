#include "profiler/scenario/near_names.h"

#include <gtest/gtest.h>

namespace reprise {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsChangesAndSwaps) {
  EXPECT_EQ(editDistance("frames", "frames"), 0);
  EXPECT_EQ(editDistance("frames", "frmes"), 1);
  EXPECT_EQ(editDistance("gain", "gian"), 1);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3);
  EXPECT_EQ(editDistance("", "abc"), 3);
}

TEST(EditDistance, TakesCaseForNoEdit) {
  EXPECT_EQ(editDistance("Radius", "rADIUS"), 0);
}

TEST(NearNames, PutsTheNearestFirst) {
  const std::vector<std::string> known = {"fames", "height", "frames"};
  EXPECT_EQ(nearNames("frame", known), (std::vector<std::string>{"frames", "fames"}));
}

TEST(NearNames, KnowsTheMemberInAnotherBlock) {
  const std::vector<std::string> known = {"Lighting.gain", "Camera.position"};
  EXPECT_EQ(nearNames("Scene.gain", known), std::vector<std::string>{"Lighting.gain"});
}

TEST(NearNames, AreNoneWhereNothingIsShared) {
  const std::vector<std::string> known = {"p", "q"};
  EXPECT_TRUE(nearNames("xy", known).empty());
}

}  // namespace
}  // namespace reprise
