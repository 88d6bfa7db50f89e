// The shake of a camera that is held in the hand. Each of its six numbers is
//   a * (0.5 sin(2 pi 0.43 f t + p1) + 0.3 sin(2 pi f t + p2) + 0.2 sin(2 pi 1.71 f t + p3))
// with the amplitude a, the frequency f and phases p that the seed gives each number: smooth, never beyond a, without a short period.
#pragma once

#include <glm/vec3.hpp>

#include "profiler/scene/moment.h"

namespace reprise {

struct Shake {
  glm::vec3 move{0};      // along the camera's right, up and back
  glm::vec3 turn_rad{0};  // about its right (pitch), up (yaw) and back (roll)
};

Shake shakeAt(const Handheld& handheld, const Moment& moment);

}  // namespace reprise
