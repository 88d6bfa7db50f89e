// Intervals read off sorted values.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "fitting/solve/order_range.h"

namespace reprise {
namespace {

std::vector<double> upTo(int count) {
  std::vector<double> values(static_cast<std::size_t>(count));
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

// k = floor((100 - 1.96 * 10) / 2) = 40: the 40th and the 61st.
TEST(MedianInterval, TakesTheOrderStatisticsOfTheFormula) {
  const OrderRange range = medianInterval(upTo(100));
  EXPECT_EQ(range.lo, 40);
  EXPECT_EQ(range.hi, 61);
}

TEST(MedianInterval, IsTheRangeOfAllWhereValuesAreFew) {
  EXPECT_EQ(medianInterval({3}).lo, 3);
  EXPECT_EQ(medianInterval({3}).hi, 3);
  EXPECT_EQ(medianInterval({5, 1, 4, 2, 3}).lo, 1);
  EXPECT_EQ(medianInterval({5, 1, 4, 2, 3}).hi, 5);
}

TEST(MedianInterval, HoldsTheMedianOfThePopulationAsOftenAsItSays) {
  std::mt19937 engine(7);
  std::exponential_distribution<double> draw(1);  // skewed: its median is ln 2
  for (const int count : {9, 25, 60}) {
    int held = 0;
    for (int trial = 0; trial < 4000; ++trial) {
      std::vector<double> values(static_cast<std::size_t>(count));
      for (double& value : values) value = draw(engine);
      const OrderRange range = medianInterval(values);
      held += range.lo <= std::log(2.0) && std::log(2.0) <= range.hi;
    }
    EXPECT_GE(held, 0.945 * 4000) << count << " values";
    EXPECT_LT(held, 4000) << count << " values: an interval that never fails says nothing";
  }
}

TEST(MiddleRange, LeavesOutTheSameShareAtBothEnds) {
  std::vector<double> values = upTo(100);
  std::shuffle(values.begin(), values.end(), std::mt19937(3));
  EXPECT_EQ(middleRange(values, 0.9).lo, 6);
  EXPECT_EQ(middleRange(values, 0.9).hi, 95);
  EXPECT_EQ(middleRange(values, 1).lo, 1);
  EXPECT_EQ(middleRange(values, 1).hi, 100);
}

}  // namespace
}  // namespace reprise
