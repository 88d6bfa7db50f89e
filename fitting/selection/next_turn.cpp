#include "fitting/selection/next_turn.h"

#include <algorithm>

namespace reprise {
namespace {

// "Never" (0) is longer than any other.
bool isAsLong(std::uint32_t period_frames, std::uint32_t than_frames) { return period_frames - 1 >= than_frames - 1; }

bool speaksAgainst(const TurnOrder& order, const Turn& turn, const TradeoffPoint& point) {
  const TradeoffPoint& failed = order.ranking[turn.place];
  if (!turn.too_large_error || !isAsLong(point.period_frames, failed.period_frames) ||
      order.configurations[point.configuration].candidate_id != order.configurations[failed.configuration].candidate_id)
    return false;
  // Multiplied out, as a prediction may be 0.
  return point.predicted_error * *turn.too_large_error > order.threshold * failed.predicted_error;
}

}  // namespace

std::optional<std::size_t> nextTurn(const TurnOrder& order, const std::vector<Turn>& taken) {
  std::optional<std::size_t> waiting;
  for (std::size_t place = 0; place < order.ranking.size(); ++place) {
    if (std::any_of(taken.begin(), taken.end(), [&](const Turn& turn) { return turn.place == place; })) continue;
    const bool waits = std::any_of(taken.begin(), taken.end(), [&](const Turn& turn) { return speaksAgainst(order, turn, order.ranking[place]); });
    if (!waits) return place;
    if (!waiting) waiting = place;
  }
  const bool accepted = std::any_of(taken.begin(), taken.end(), [](const Turn& turn) { return turn.accepted; });
  return accepted ? std::nullopt : waiting;
}

}  // namespace reprise
