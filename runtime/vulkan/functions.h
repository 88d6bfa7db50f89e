// The Vulkan functions that Reprise calls, loaded for one device.
//
// A table of our own instead of the loader's exported symbols or a global meta-loader: the runtime lives inside applications
// that have chosen theirs already, and must not collide with it.
#pragma once

#include <vulkan/vulkan_core.h>

#include "runtime/base/result.h"

#define REPRISE_DEVICE_FUNCTIONS(X)                                                                        \
  X(vkAllocateCommandBuffers) X(vkAllocateDescriptorSets) X(vkAllocateMemory) X(vkBeginCommandBuffer)      \
  X(vkBindBufferMemory) X(vkBindImageMemory) X(vkCmdBeginQuery) X(vkCmdBindDescriptorSets)                 \
  X(vkCmdBindIndexBuffer) X(vkCmdBindPipeline) X(vkCmdBindVertexBuffers) X(vkCmdBlitImage)                 \
  X(vkCmdCopyBufferToImage) X(vkCmdCopyImageToBuffer) X(vkCmdDraw) X(vkCmdDrawIndexed) X(vkCmdEndQuery)    \
  X(vkCmdPipelineBarrier) X(vkCmdPushConstants) X(vkCmdResetQueryPool) X(vkCmdSetScissor)                  \
  X(vkCmdSetViewport) X(vkCmdWriteTimestamp) X(vkCreateBuffer) X(vkCreateCommandPool)                      \
  X(vkCreateDescriptorPool) X(vkCreateDescriptorSetLayout) X(vkCreateFence) X(vkCreateGraphicsPipelines)   \
  X(vkCreateImage) X(vkCreateImageView) X(vkCreatePipelineLayout) X(vkCreateQueryPool) X(vkCreateSampler)  \
  X(vkCreateShaderModule) X(vkDestroyBuffer) X(vkDestroyCommandPool) X(vkDestroyDescriptorPool)            \
  X(vkDestroyDescriptorSetLayout) X(vkDestroyFence) X(vkDestroyImage) X(vkDestroyImageView)                \
  X(vkDestroyPipeline) X(vkDestroyPipelineLayout) X(vkDestroyQueryPool) X(vkDestroySampler)                \
  X(vkDestroyShaderModule) X(vkDeviceWaitIdle) X(vkEndCommandBuffer) X(vkFreeMemory)                       \
  X(vkGetBufferMemoryRequirements) X(vkGetDeviceQueue) X(vkGetImageMemoryRequirements)                     \
  X(vkGetQueryPoolResults) X(vkMapMemory) X(vkQueueSubmit) X(vkResetCommandBuffer) X(vkResetFences)        \
  X(vkUpdateDescriptorSets) X(vkWaitForFences) X(vkCreateBufferView) X(vkDestroyBufferView)                \
  X(vkCmdClearAttachments) X(vkCmdFillBuffer)

// Of extensions that a recipe may require; null where the device was made without.
#define REPRISE_OPTIONAL_DEVICE_FUNCTIONS(X) X(vkCmdBeginConditionalRenderingEXT) X(vkCmdEndConditionalRenderingEXT)

// Core in Vulkan 1.3, else under the name of the extension; looked up under both.
#define REPRISE_DEVICE_FUNCTIONS_KHR(X) X(vkCmdBeginRendering) X(vkCmdEndRendering)

#define REPRISE_INSTANCE_FUNCTIONS(X)                                                            \
  X(vkGetPhysicalDeviceFeatures2) X(vkGetPhysicalDeviceFormatProperties)                         \
  X(vkGetPhysicalDeviceMemoryProperties) X(vkGetPhysicalDeviceProperties)

namespace reprise {

#define REPRISE_DECLARE(name) PFN_##name name = nullptr;

struct VulkanFunctions {
  REPRISE_DEVICE_FUNCTIONS(REPRISE_DECLARE)
  REPRISE_DEVICE_FUNCTIONS_KHR(REPRISE_DECLARE)
  REPRISE_OPTIONAL_DEVICE_FUNCTIONS(REPRISE_DECLARE)
  REPRISE_INSTANCE_FUNCTIONS(REPRISE_DECLARE)
};

#undef REPRISE_DECLARE

struct FunctionSource {
  VkInstance instance = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
  PFN_vkGetDeviceProcAddr get_device_proc_addr = nullptr;
};

// Error: device.function (kMachine), naming the function that the device lacks.
Result<VulkanFunctions> loadFunctions(const FunctionSource& source);

}  // namespace reprise
