// Which point of the ranking is validated next.
//
// In predicted order. A point that failed for its error tells of its candidate that the training sessions did not show how its error
// grows: points of the same candidate at the same or a longer period wait until all others had their turn, and are passed over once
// anything was accepted. So a few attempts reach the shorter period of a good candidate instead of every way to fail at the longer one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fitting/selection/select.h"

namespace reprise {

struct Turn {
  std::size_t place = 0;  // in the ranking
  bool accepted = false;
  bool failed_for_its_error = false;
};

// A place in the ranking that is not among `taken`; nullopt where none is left. `configurations` are those that the ranking points to.
std::optional<std::size_t> nextTurn(const std::vector<Configuration>& configurations, const std::vector<TradeoffPoint>& ranking,
                                    const std::vector<Turn>& taken);

}  // namespace reprise
