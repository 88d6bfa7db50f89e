// Command buffers that are recorded, submitted and waited for, one at a time.
#pragma once

#include <functional>

#include "runtime/vulkan/context.h"
#include "runtime/vulkan/handle.h"

namespace reprise {

class Commands {
 public:
  static Result<Commands> create(const Context& context);
  static Result<Commands> create(const DeviceView& device, VkQueue queue, std::uint32_t queue_family);

  // Records with `record`, submits, waits for the fence. Errors: that of `record`; device.timeout after timeout_s; device.lost.
  Result<void> run(const std::function<Result<void>(VkCommandBuffer)>& record, double timeout_s = 20);

  // The two halves, for timing the submission alone.
  Result<void> record(const std::function<Result<void>(VkCommandBuffer)>& record);
  Result<void> submitAndWait(double timeout_s);

 private:
  DeviceView device_;
  VkQueue queue_ = VK_NULL_HANDLE;
  Handle<VkCommandPool> pool_;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE;
  Handle<VkFence> fence_;
};

// An image layout change with full dependency on what came before; for set-up and read-back, not for frames.
struct LayoutChange {
  VkImage image = VK_NULL_HANDLE;
  VkImageLayout from = VK_IMAGE_LAYOUT_UNDEFINED;
  VkImageLayout to = VK_IMAGE_LAYOUT_GENERAL;
  VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};
void changeLayout(const DeviceView& device, VkCommandBuffer commands, const LayoutChange& change);

}  // namespace reprise
