// A buffer in host-visible, coherent memory, mapped for as long as it lives: cached by the processor if it is a transfer's destination,
// which the host reads, and on the device where that can be mapped if the device reads it or shaders write it.
#pragma once

#include <cstddef>
#include <span>

#include "runtime/vulkan/device.h"
#include "runtime/vulkan/handle.h"

namespace reprise {

struct Buffer {
  Handle<VkDeviceMemory> memory;  // before the buffer, so that it is freed after it
  Handle<VkBuffer> buffer;
  std::span<std::byte> mapped;
};

// size_bytes > 0. Errors: device.memory, device.call.
Result<Buffer> createBuffer(const DeviceView& device, VkDeviceSize size_bytes, VkBufferUsageFlags usage);

}  // namespace reprise
