// Ranges read off sorted values, without any assumption on how they are distributed.
//
// medianInterval: the order statistics k and N + 1 − k that hold the median of the population with at least 95% probability, with
// k = ⌊(N − 1.96 √N) / 2⌋ (the binomial distribution's normal approximation; Conover 1999, section 3.2), at least 1. Fewer than six
// values cannot give 95%: then it is the range of all. Values that follow one another in time are not independent; the interval is
// too narrow then.
// middleRange: the values that leave out (1 − share) / 2 at each end, by nearest rank.
#pragma once

#include <vector>

namespace reprise {

struct OrderRange {
  double lo = 0, hi = 0;
};

// Of at least one value (checked), in any order.
OrderRange medianInterval(std::vector<double> values);
OrderRange middleRange(std::vector<double> values, double share);

}  // namespace reprise
