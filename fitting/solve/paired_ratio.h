// Speed-up from alternating measurements: the median over pairs of original time / variant time, with a 95% percentile
// bootstrap interval over the pairs (Efron 1979). Pairing cancels what both share: the frame's content, the machine's drift.
// Known to be wrong: a disturbance longer than a pair widens the interval; fewer than about 10 pairs make it too narrow.
#pragma once

#include <cstdint>
#include <span>

namespace reprise {

struct PairedRatio {
  int pairs = 0;                 // used; times that are not positive and finite drop their pair
  double ratio = 0;              // > 1: the variant is faster. NaN, as all below, without pairs
  double lo = 0, hi = 0;         // 95%
  double original_median_ms = 0, variant_median_ms = 0;
  double variant_p95_ms = 0, variant_worst_ms = 0;
};

struct BootstrapOptions {
  std::uint64_t seed = 1;
  int resamples = 2000;
};

// original_ms[i] and variant_ms[i] are of one pair; the lists must be equally long (checked). Deterministic on every machine.
PairedRatio pairedRatio(std::span<const double> original_ms, std::span<const double> variant_ms,
                        const BootstrapOptions& options = {});

}  // namespace reprise
