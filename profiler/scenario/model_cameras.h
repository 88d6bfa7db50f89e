// Cameras of models: which node a session's camera follows, and the lens that the file gives it.
#pragma once

#include "profiler/scenario/scenario.h"

namespace reprise {

// Models must have been loaded. Sets the places in all ModelCameraPath and the lens of their cameras (angle or height, planes).
// Errors: scenario.value at the session: no such model, no such camera, a camera that the file's scene does not hold.
Result<void> placeModelCameras(Scenario& scenario);

}  // namespace reprise
