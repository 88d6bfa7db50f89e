// A device to create things on: functions, handles and memory types. Owns nothing; cheap to copy.
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>

#include "runtime/vulkan/functions.h"

namespace reprise {

struct DeviceView {
  VulkanFunctions fn;
  VkPhysicalDevice physical_device = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory = {};
};

// Error: device.function (kMachine).
Result<DeviceView> viewDevice(const FunctionSource& source, VkPhysicalDevice physical_device);

// The error for a failed call: device.lost and device.timeout (kMeasurement), device.memory and device.call (kMachine).
Error vulkanError(VkResult result, const std::string& call);

// Index of a memory type of `bits` with the wanted properties; falls back to any type of `bits`.
std::uint32_t memoryTypeIndex(const DeviceView& device, std::uint32_t bits, VkMemoryPropertyFlags wanted);

}  // namespace reprise

#define REPRISE_VK(call)                                                              \
  do {                                                                                \
    const VkResult reprise_vk_result = (call);                                        \
    if (reprise_vk_result != VK_SUCCESS) return ::reprise::vulkanError(reprise_vk_result, #call); \
  } while (false)
