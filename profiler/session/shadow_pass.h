// A shadow map: the depth of the objects as a light sees them (Williams 1978), drawn with the vertex shader of the scenario, whose view,
// projection, view_projection and camera_position are the light's. What the fragment shader discards casts a shadow all the same.
#pragma once

#include "profiler/session/scene_pass.h"
#include "runtime/package/package.h"

namespace reprise {

// original: the package with the vertex shader. Errors: device.*, those of createSceneObjects.
Result<std::unique_ptr<ScenePass>> createShadowPass(const PassParts& parts, const Package& original);

}  // namespace reprise
