// Which point of the ranking is validated next.
//
// In predicted order, but for points that a failure speaks against. A point of a candidate that failed for its error, measured at ε against a
// predicted ε̂, tells that training did not show how that candidate's error grows: points of the same candidate at the same or a longer period
// are expected at ε/ε̂ times their own prediction, and wait if that exceeds the threshold. Those that wait get their turn after all others, and
// none once anything was accepted. So a few attempts reach the shorter period of a good candidate instead of every way to fail at the longer
// one, and a filter with a smaller error still has its turn.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fitting/selection/select.h"

namespace reprise {

struct Turn {
  std::size_t place = 0;  // in the ranking
  bool accepted = false;
  std::optional<double> too_large_error;  // measured, where that is why it was not accepted
};

// What there is to choose from: the ranking, the configurations that it points to, and the largest allowed error.
struct TurnOrder {
  const std::vector<Configuration>& configurations;
  const std::vector<TradeoffPoint>& ranking;
  double threshold = 0;
};

// A place in the ranking that is not among `taken`; nullopt where none is left.
std::optional<std::size_t> nextTurn(const TurnOrder& order, const std::vector<Turn>& taken);

}  // namespace reprise
