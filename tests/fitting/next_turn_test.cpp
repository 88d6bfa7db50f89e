// The order in which variants are validated.
#include "fitting/selection/next_turn.h"

#include <gtest/gtest.h>

namespace reprise {
namespace {

constexpr std::uint32_t kNever = 0;
constexpr double kThreshold = 0.02;

struct Ranked {
  std::vector<Configuration> configurations;
  std::vector<TradeoffPoint> ranking;

  void add(const std::string& candidate, std::uint32_t period_frames, double predicted_error = 0.01) {
    Configuration configuration;
    configuration.candidate_id = candidate;
    TradeoffPoint point;
    point.configuration = configurations.size();
    point.period_frames = period_frames;
    point.predicted_error = predicted_error;
    configurations.push_back(configuration);
    ranking.push_back(point);
  }

  std::optional<std::size_t> next(const std::vector<Turn>& taken) const { return nextTurn({configurations, ranking, kThreshold}, taken); }
};

Turn accepted(std::size_t place) { return {place, true, std::nullopt}; }
Turn tooSlow(std::size_t place) { return {place, false, std::nullopt}; }
Turn tooWrong(std::size_t place, double measured_error) { return {place, false, measured_error}; }

TEST(NextTurn, FollowsThePredictedOrder) {
  Ranked ranked;
  for (const char* candidate : {"a", "b", "c"}) ranked.add(candidate, 8);
  EXPECT_EQ(ranked.next({}), 0u);
  EXPECT_EQ(ranked.next({tooSlow(0)}), 1u);
  EXPECT_EQ(ranked.next({tooSlow(0), accepted(1)}), 2u);
  EXPECT_EQ(ranked.next({tooSlow(0), tooSlow(1), tooSlow(2)}), std::nullopt);
}

TEST(NextTurn, GoesToShorterPeriodsWhereTheErrorWasTooLarge) {
  Ranked ranked;
  ranked.add("lit", kNever);
  ranked.add("lit", kNever);
  ranked.add("lit", 16);
  ranked.add("albedo", kNever);
  const Turn failed = tooWrong(0, 0.03);
  EXPECT_EQ(ranked.next({failed}), 2u);
  EXPECT_EQ(ranked.next({failed, tooWrong(2, 0.021)}), 3u);
  EXPECT_EQ(ranked.next({failed, tooWrong(2, 0.021), tooSlow(3)}), 1u);
}

TEST(NextTurn, LetsASmallerErrorAtTheSamePeriodHaveItsTurn) {
  Ranked ranked;
  ranked.add("vein", 16, 0.0196);
  ranked.add("vein", 16, 0.0091);
  EXPECT_EQ(ranked.next({tooWrong(0, 0.0205)}), 1u);   // expected at 0.0095
  ranked.add("vein", 8, 0.0147);
  EXPECT_EQ(ranked.next({tooWrong(0, 0.0450)}), 2u);   // expected at 0.0209
}

TEST(NextTurn, PassesOverWhatWaitsOnceAnythingWasAccepted) {
  Ranked ranked;
  ranked.add("lit", 32);
  ranked.add("lit", 64);
  ranked.add("lit", 16);
  EXPECT_EQ(ranked.next({tooWrong(0, 0.03), accepted(2)}), std::nullopt);
}

TEST(NextTurn, DoesNotWaitAfterFailuresOfAnotherKind) {
  Ranked ranked;
  ranked.add("lit", 16);
  ranked.add("lit", 16);
  EXPECT_EQ(ranked.next({tooSlow(0)}), 1u);
}

}  // namespace
}  // namespace reprise
