// When something is evaluated, and the vectors and angles that a moment gives.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "profiler/scenario/scenario.h"

namespace reprise {

struct Moment {
  double time_s = 0;
  double steps = 0;  // frames times speed
  std::uint32_t seed = 1;  // Scenario::seed
};

// The track must yield three values (checked).
glm::vec3 vectorAt(const Track& track, const Moment& moment);

// start + step * steps, reduced in double, so that late frames are as exact as early ones.
float turnAt(float start_rad, float step_rad, double steps);

inline glm::vec3 vectorOf(const std::array<float, 3>& values) { return {values[0], values[1], values[2]}; }

}  // namespace reprise
