#include <gtest/gtest.h>

#include <cmath>

#include "fitting/selection/pace.h"

namespace reprise {
namespace {

TEST(Pace, EqualRunsHaveTheSamePace) { EXPECT_DOUBLE_EQ(paceOf({20, 1e5}, {20, 1e5}), 1); }

TEST(Pace, MoreFragmentsInProportionateTimeAreTheSamePace) { EXPECT_DOUBLE_EQ(paceOf({20, 1e5}, {40, 2e5}), 1); }

TEST(Pace, ASlowerMachineShows) { EXPECT_DOUBLE_EQ(paceOf({20, 1e5}, {24, 1e5}), 1.2); }

TEST(Pace, IsUnknownWithoutWork) {
  EXPECT_TRUE(std::isnan(paceOf({0, 1e5}, {20, 1e5})));
  EXPECT_TRUE(std::isnan(paceOf({20, 1e5}, {20, 0})));
  EXPECT_TRUE(std::isnan(paceOf({std::nan(""), 1e5}, {20, 1e5})));
}

}  // namespace
}  // namespace reprise
