// A G-buffer: all objects as the camera sees them, with shaders of their own, into textures that the shader samples.
#pragma once

#include "profiler/session/scene_pass.h"
#include "runtime/package/package.h"

namespace reprise {

// package: the compiled pair of shaders, with an original to play. Errors: those of SceneRenderer and Player::create.
Result<std::unique_ptr<ScenePass>> createGBufferPass(const PassParts& parts, const Package& package);

}  // namespace reprise
