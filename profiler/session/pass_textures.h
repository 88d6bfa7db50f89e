// The images that the passes of a scenario render to and shaders sample.
#pragma once

#include <memory>
#include <optional>

#include "profiler/scenario/scenario.h"
#include "profiler/session/render_targets.h"
#include "runtime/package/interface.h"
#include "runtime/vulkan/context.h"
#include "runtime/vulkan/handle.h"

namespace reprise {

struct PassTextures {
  std::vector<RenderTargets> targets;  // by pass
  // Of depth compared, what lies outside being lit; of outputs, and of depth as a number.
  Handle<VkSampler> compare, nearest, linear;
};

// "rgba16_sfloat" and the others of RenderState::color_formats.
VkFormat colorFormatOf(const std::string& name);

// Errors: device.*.
Result<PassTextures> createPassTextures(const Context& context, const Scenario& scenario);

// What a descriptor of that name gets; nothing if no pass makes it.
std::optional<VkDescriptorImageInfo> passTexture(const Scenario& scenario, const PassTextures& textures, const Descriptor& descriptor);

}  // namespace reprise
