// The order in which variants are validated.
#include "fitting/selection/next_turn.h"

#include <gtest/gtest.h>

namespace reprise {
namespace {

constexpr std::uint32_t kNever = 0;

struct Ranked {
  std::vector<Configuration> configurations;
  std::vector<TradeoffPoint> ranking;

  void add(const std::string& candidate, std::uint32_t period_frames) {
    Configuration configuration;
    configuration.candidate_id = candidate;
    TradeoffPoint point;
    point.configuration = configurations.size();
    point.period_frames = period_frames;
    configurations.push_back(configuration);
    ranking.push_back(point);
  }

  std::optional<std::size_t> next(const std::vector<Turn>& taken) const { return nextTurn(configurations, ranking, taken); }
};

TEST(NextTurn, FollowsThePredictedOrder) {
  Ranked ranked;
  for (const char* candidate : {"a", "b", "c"}) ranked.add(candidate, 8);
  EXPECT_EQ(ranked.next({}), 0u);
  EXPECT_EQ(ranked.next({{0, false, false}}), 1u);
  EXPECT_EQ(ranked.next({{0, false, false}, {1, true, false}}), 2u);
  EXPECT_EQ(ranked.next({{0, false, false}, {1, false, false}, {2, false, false}}), std::nullopt);
}

TEST(NextTurn, GoesToShorterPeriodsWhereTheErrorWasTooLarge) {
  Ranked ranked;
  ranked.add("lit", kNever);
  ranked.add("lit", kNever);
  ranked.add("lit", 16);
  ranked.add("albedo", kNever);
  const Turn failed{0, false, true};
  EXPECT_EQ(ranked.next({failed}), 2u);
  EXPECT_EQ(ranked.next({failed, {2, false, true}}), 3u);
  EXPECT_EQ(ranked.next({failed, {2, false, true}, {3, false, false}}), 1u);
}

TEST(NextTurn, PassesOverWhatWaitsOnceAnythingWasAccepted) {
  Ranked ranked;
  ranked.add("lit", 32);
  ranked.add("lit", 64);
  ranked.add("lit", 16);
  EXPECT_EQ(ranked.next({{0, false, true}, {2, true, false}}), std::nullopt);
}

TEST(NextTurn, DoesNotWaitAfterFailuresOfAnotherKind) {
  Ranked ranked;
  ranked.add("lit", 16);
  ranked.add("lit", 16);
  EXPECT_EQ(ranked.next({{0, false, false}}), 1u);
}

}  // namespace
}  // namespace reprise
