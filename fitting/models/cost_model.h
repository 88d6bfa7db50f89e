// Frame time of a variant: Δt = H Δhit + M Δmiss + c (Eq. 5 of the survey, section 4.1).
// H, M: shaded fragments of the frame that hit and that missed, overdraw included. Δhit, Δmiss: time per fragment (ns).
// c: the frame's constant overhead (ms). All are ≥ 0. Cost per fragment at period n, Eq. 6: r̂ = λ Δhit + (1 − λ) Δmiss with
// λ = λ(n) of hit_rate_model.h; the frame takes r̂ · fragments + c.
// Known to be wrong: where groups of fragments pay together (branches on a GPU or under a mask: a group with one miss costs
// a miss) the time depends on how misses are clustered, so fit each pattern and block size by itself.
#pragma once

namespace reprise {

struct CostParameters {
  double hit_ns = 0;
  double miss_ns = 0;
  double overhead_ms = 0;
  bool operator==(const CostParameters&) const = default;
};

// Eq. 5, in ms; hits and misses in shaded fragments.
double frameTimeMs(const CostParameters& cost, double hits, double misses);

}  // namespace reprise
