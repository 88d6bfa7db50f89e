#include "runtime/vulkan/buffer.h"

namespace reprise {
namespace {

constexpr VkMemoryPropertyFlags kMapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;

// Reading memory that the processor does not cache is some fifty times slower; vertices across the bus are read anew for every pass.
VkMemoryPropertyFlags preferred(VkBufferUsageFlags usage) {
  if ((usage & VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) != 0) return kMapped | VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
  if ((usage & VK_BUFFER_USAGE_TRANSFER_DST_BIT) != 0) return kMapped | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
  if ((usage & VK_BUFFER_USAGE_TRANSFER_SRC_BIT) != 0) return kMapped;
  return kMapped | VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
}

std::uint32_t typeWith(const DeviceView& device, std::uint32_t bits, VkMemoryPropertyFlags wanted) {
  const std::uint32_t index = memoryTypeIndex(device, bits, wanted);
  const bool has_all = (device.memory.memoryTypes[index].propertyFlags & wanted) == wanted;
  return has_all ? index : memoryTypeIndex(device, bits, kMapped);
}

}  // namespace

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
  allocate.memoryTypeIndex = typeWith(device, needs.memoryTypeBits, preferred(usage));
  VkDeviceMemory memory = VK_NULL_HANDLE;
  if (device.fn.vkAllocateMemory(device.device, &allocate, nullptr, &memory) != VK_SUCCESS) {
    // Mapped device memory may be small (256 MiB) and full.
    allocate.memoryTypeIndex = memoryTypeIndex(device, needs.memoryTypeBits, kMapped);
    REPRISE_VK(device.fn.vkAllocateMemory(device.device, &allocate, nullptr, &memory));
  }
  result.memory = {device.device, memory, device.fn.vkFreeMemory};
  REPRISE_VK(device.fn.vkBindBufferMemory(device.device, buffer, memory, 0));
  void* address = nullptr;
  REPRISE_VK(device.fn.vkMapMemory(device.device, memory, 0, VK_WHOLE_SIZE, 0, &address));
  result.mapped = {static_cast<std::byte*>(address), static_cast<std::size_t>(size_bytes)};
  return result;
}

}  // namespace reprise
