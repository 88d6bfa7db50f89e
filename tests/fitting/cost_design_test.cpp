// Which training frames can identify the cost model.
#include "fitting/solve/cost_design.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace reprise {
namespace {

// Frames of periods 1, 2, 4 and 8, with the coverage that `fragmentsAt` gives each.
template <typename Coverage>
std::vector<CostPoint> framesOf(Coverage fragmentsAt) {
  std::vector<CostPoint> points;
  for (const double period : {1.0, 2.0, 4.0, 8.0})
    for (int frame = 0; frame < 20; ++frame) {
      const double fragments = fragmentsAt(frame);
      points.push_back({fragments * (1 - 1 / period), fragments / period, 1});
    }
  return points;
}

TEST(CostDesign, OfConstantCoverageIsNotIdentifiable) {
  const CostDesign design = judgeCostDesign(framesOf([](int) { return 1000.0; }));
  EXPECT_FALSE(design.isIdentifiable());
  EXPECT_NE(explainCostDesign(design).find("covered pixels hardly vary"), std::string::npos) << explainCostDesign(design);
  EXPECT_NE(explainCostDesign(design).find("comes nearer"), std::string::npos);
}

TEST(CostDesign, OfNearlyConstantCoverageIsNotIdentifiable) {
  const CostDesign design = judgeCostDesign(framesOf([](int frame) { return 1000.0 + 5 * (frame % 3); }));
  EXPECT_FALSE(design.isIdentifiable());
  EXPECT_NE(explainCostDesign(design).find("1000 to 1010 fragments, 1.01 times"), std::string::npos) << explainCostDesign(design);
}

TEST(CostDesign, OfVaryingCoverageIsIdentifiable) {
  const CostDesign design = judgeCostDesign(framesOf([](int frame) { return 1000.0 + 100 * frame; }));
  EXPECT_TRUE(design.isIdentifiable());
  EXPECT_EQ(explainCostDesign(design), "");
  EXPECT_DOUBLE_EQ(design.least_coverage, 1000);
  EXPECT_DOUBLE_EQ(design.most_coverage, 2900);
}

TEST(CostDesign, OfASteadyShareOfMissesIsNotIdentifiable) {
  std::vector<CostPoint> points;
  for (int frame = 0; frame < 80; ++frame) points.push_back({750.0 + 75 * frame, 250.0 + 25 * frame, 1});
  const CostDesign design = judgeCostDesign(points);
  EXPECT_FALSE(design.isIdentifiable());
  EXPECT_NE(explainCostDesign(design).find("the share of misses hardly varies"), std::string::npos) << explainCostDesign(design);
}

// Misses that are a fixed number of pixels plus a fixed part of the rest: both vary, along one line.
TEST(CostDesign, OfCoverageThatFollowsMissesIsNotIdentifiable) {
  std::vector<CostPoint> points;
  for (int frame = 0; frame < 80; ++frame) points.push_back({1000.0 - 10 * frame, 10.0 * frame + 20 * frame, 1});
  const CostDesign design = judgeCostDesign(points);
  EXPECT_FALSE(design.isIdentifiable());
  EXPECT_NE(explainCostDesign(design).find("apart from each other"), std::string::npos) << explainCostDesign(design);
}

TEST(CostDesign, LeavesOutEmptyFrames) {
  EXPECT_EQ(judgeCostDesign(std::vector<CostPoint>{{0, 0, 1}}).frames, 0u);
  EXPECT_EQ(explainCostDesign(judgeCostDesign({})), "");
}

}  // namespace
}  // namespace reprise
