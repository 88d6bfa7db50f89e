// Where a session's camera is at a moment: its path, then the cuts that have been, then the shake.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "profiler/scene/frame_state.h"
#include "profiler/scene/moment.h"

namespace reprise {

struct CameraPose {
  glm::vec3 eye{0};
  glm::mat4 view{1};     // from the world; the camera looks along -z, +y is up
  float fov_y_deg = 45;  // perspective
};

// state: placements and poses of the models, for a camera of one of them.
CameraPose cameraPoseAt(const Camera& camera, const Moment& moment, const FrameState& state);

}  // namespace reprise
