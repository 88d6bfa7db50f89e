// The passes of a strategy where every second frame fetches what the frame before it stored, and is not fetched from itself: pairs of
// eyes (PreviousImage::kOtherEye).
//
//   frames that are wholly due   one pass: the whole shader, which stores the payload
//   the others                   the strategy's passes, which look up and store nothing
//
// Nothing is looked up in vain in the first, and the second write no payload that no one reads. So one image is kept in place of two.
#pragma once

#include <vector>

#include "compiler/strategies/strategy.h"

namespace reprise {

// Whether a strategy can do so: not where a later pass of the frame reads the payload back.
bool storesOnceAPair(const Strategy& strategy);

std::vector<PassPlan> passesOfPairs(const Strategy& strategy);

}  // namespace reprise
