#include "fitting/selection/next_turn.h"

#include <algorithm>

namespace reprise {
namespace {

// "Never" (0) is longer than any other.
bool isAsLong(std::uint32_t period_frames, std::uint32_t than_frames) { return period_frames - 1 >= than_frames - 1; }

}  // namespace

std::optional<std::size_t> nextTurn(const std::vector<Configuration>& configurations, const std::vector<TradeoffPoint>& ranking,
                                    const std::vector<Turn>& taken) {
  const auto waits = [&](const TradeoffPoint& point) {
    return std::any_of(taken.begin(), taken.end(), [&](const Turn& turn) {
      const TradeoffPoint& failed = ranking[turn.place];
      return turn.failed_for_its_error && isAsLong(point.period_frames, failed.period_frames) &&
             configurations[point.configuration].candidate_id == configurations[failed.configuration].candidate_id;
    });
  };
  std::optional<std::size_t> waiting;
  for (std::size_t place = 0; place < ranking.size(); ++place) {
    if (std::any_of(taken.begin(), taken.end(), [&](const Turn& turn) { return turn.place == place; })) continue;
    if (!waits(ranking[place])) return place;
    if (!waiting) waiting = place;
  }
  const bool accepted = std::any_of(taken.begin(), taken.end(), [](const Turn& turn) { return turn.accepted; });
  return accepted ? std::nullopt : waiting;
}

}  // namespace reprise
