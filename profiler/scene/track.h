// Tracks as functions of time.
//
//   fixed        value
//   key frames   linear between the neighbours, the first before all, the last after all
//   oscillation  base + amplitude * sin(2 pi t / period_s + phase_rad), component by component
//   random walk  a uniform quadratic B-spline over control points kWalkKnot_s apart. The first two are base;
//   each further one
//                moves every component by a uniform step of at most step_per_s * kWalkKnot_s and is folded
//                back into base +- extent. The curve stays in the hull of its control points, so within these
//                bounds, and is as smooth as a hand-held camera (continuous speed).
//   flicker      base + amplitude * u_k with k = floor(t rate_hz) and u_k uniform in [-1, 1), by the seed and k
// Times are in seconds and at least 0; earlier ones are taken as 0.
#pragma once

#include <cstdint>
#include <vector>

#include "profiler/scenario/scenario.h"

namespace reprise {

inline constexpr double kWalkKnot_s = 0.25;

// seed is mixed into those of random walks and flickers (Scenario::seed).
std::vector<float> evaluateTrack(const Track& track, double time_s, std::uint32_t seed);

}  // namespace reprise
