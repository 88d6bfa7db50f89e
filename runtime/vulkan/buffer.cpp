#include "runtime/vulkan/buffer.h"

namespace reprise {

Result<Buffer> createBuffer(const DeviceView& device, VkDeviceSize size_bytes, VkBufferUsageFlags usage) {
  Buffer result;
  VkBufferCreateInfo create{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  create.size = size_bytes;
  create.usage = usage;
  VkBuffer buffer = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateBuffer(device.device, &create, nullptr, &buffer));
  result.buffer = {device.device, buffer, device.fn.vkDestroyBuffer};
  VkMemoryRequirements needs;
  device.fn.vkGetBufferMemoryRequirements(device.device, buffer, &needs);
  VkMemoryAllocateInfo allocate{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  allocate.allocationSize = needs.size;
  allocate.memoryTypeIndex = memoryTypeIndex(
      device, needs.memoryTypeBits, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkAllocateMemory(device.device, &allocate, nullptr, &memory));
  result.memory = {device.device, memory, device.fn.vkFreeMemory};
  REPRISE_VK(device.fn.vkBindBufferMemory(device.device, buffer, memory, 0));
  void* address = nullptr;
  REPRISE_VK(device.fn.vkMapMemory(device.device, memory, 0, VK_WHOLE_SIZE, 0, &address));
  result.mapped = {static_cast<std::byte*>(address), static_cast<std::size_t>(size_bytes)};
  return result;
}

}  // namespace reprise
