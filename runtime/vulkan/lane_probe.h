// Whether lanes whose results go nowhere load from storage buffers all the same, as their neighbours' derivatives need them to.
//
// The four lanes of a quad compute derivatives and implicit levels of detail from one another, also lanes of pixels that are beside the
// triangle (helper), that an early depth or stencil test rejected, or that discarded before the load. Vulkan wants loads of helper
// lanes to be like any others; there are devices (lavapipe of Mesa 22.3) on which all three get 0 from storage buffers.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <string>

#include "runtime/base/result.h"

namespace reprise {

class Context;

struct LaneLoads {
  bool helper = true, rejected = true, discarded = true;
  bool operator==(const LaneLoads&) const = default;
};

// A device with dynamic rendering and a queue for graphics that nobody else uses meanwhile.
struct ProbedDevice {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physical_device = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
  PFN_vkGetDeviceProcAddr get_device_proc_addr = nullptr;
  VkQueue queue = VK_NULL_HANDLE;
  std::uint32_t queue_family = 0;
};

// Draws one triangle of 16x16 pixels, waits for it and looks at the quads. What could not be seen counts as not loading. Errors (kMachine,
// kMeasurement): device.function, device.memory, device.call, device.lost, device.timeout.
Result<LaneLoads> probeLanes(const ProbedDevice& device);
Result<LaneLoads> probeLanes(const Context& context);

// "no (helper, rejected)", "yes": for people.
std::string describeLanes(const LaneLoads& lanes);

}  // namespace reprise
