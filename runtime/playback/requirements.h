// What a recipe asks of the application's pipeline and of the device.
#pragma once

#include <string>

#include "runtime/playback/player.h"
#include "runtime/vulkan/device.h"

namespace reprise {

// Why the recipe cannot be played here; empty if it can. Version 1 caches no multisampled or blended pipelines.
std::string missingRequirement(const DeviceView& device, const Recipe& recipe, const ApplicationPipeline& application);

// The application's part of a player's creation. Error (kInput): player.pipeline, where state is missing without which no
// recipe of the package can be played.
Result<void> checkApplication(const Package& package, const ApplicationPipeline& application);

// One frame's. Errors (kInput): player.extent (zero), player.target_missing (fewer colour targets than the pipeline's, or no
// depth target where it has one).
Result<void> checkFrame(const ApplicationPipeline& application, const FrameInputs& frame);

}  // namespace reprise
