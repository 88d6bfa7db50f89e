#include "profiler/scene/moment.h"

#include <cmath>

#include "profiler/scene/track.h"

namespace reprise {

glm::vec3 vectorAt(const Track& track, const Moment& moment) {
  const std::vector<float> values = evaluateTrack(track, moment.time_s, moment.seed);
  REPRISE_CHECK(values.size() == 3, values.size());
  return {values[0], values[1], values[2]};
}

float turnAt(float start_rad, float step_rad, double steps) {
  return static_cast<float>(std::fmod(start_rad + static_cast<double>(step_rad) * steps, 6.283185307179586));
}

}  // namespace reprise
