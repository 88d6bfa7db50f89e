// A chain (analysis/chains.h) split in two: what is kept, and what is computed anew and joined with it.
//
//   sum = t1 + t2 - t3 + t4,  kept = {t1, t3}:  partial = t1 - t3,  sum' = partial + t2 + t4
//
// sum' equals sum but for rounding: for sums and products of n terms |sum' - sum| <= 2 (n - 1) u S with u = 2^-24 and S the sum
// (product) of the |terms| (Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed., section 4.2); minima and maxima
// are exact but for NaN. Wrong where that matters: sums that nearly cancel, products that overflow in another order.
#pragma once

#include <cstdint>

#include "compiler/analysis/chains.h"
#include "compiler/ir/module.h"

namespace reprise {

struct RegroupPlace {
  std::uint32_t function = 0;
  std::uint32_t partial = 0;  // the id that the kept terms' result gets, or has
};

// The partial result of the kept terms is computed before the chain's root; nothing uses it yet.
Module addPartial(const Module& module, const RegroupPlace& place, const Regrouping& regrouping);

// The root becomes the partial result joined with the other terms, in their order.
Module usePartial(const Module& module, const RegroupPlace& place, const Regrouping& regrouping);

}  // namespace reprise
