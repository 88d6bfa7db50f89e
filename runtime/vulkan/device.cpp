#include "runtime/vulkan/device.h"

namespace reprise {
namespace {

// "device.fn.vkCreateImage(...)" -> "vkCreateImage"
std::string functionName(const std::string& call) {
  const std::size_t end = call.find('(');
  const std::size_t start = call.rfind("vk", end);
  return start == std::string::npos ? call : call.substr(start, end - start);
}

}  // namespace

Result<DeviceView> viewDevice(const FunctionSource& source, VkPhysicalDevice physical_device) {
  DeviceView view;
  REPRISE_ASSIGN(view.fn, loadFunctions(source));
  view.physical_device = physical_device;
  view.device = source.device;
  view.fn.vkGetPhysicalDeviceMemoryProperties(physical_device, &view.memory);
  return view;
}

Error vulkanError(VkResult result, const std::string& call) {
  const std::string name = functionName(call);
  switch (result) {
    case VK_ERROR_DEVICE_LOST: return {ErrorKind::kMeasurement, "device.lost", "the Vulkan device was lost in " + name, {}};
    case VK_TIMEOUT: return {ErrorKind::kMeasurement, "device.timeout", "the Vulkan device did not finish in time (" + name + ")", {}};
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    case VK_ERROR_OUT_OF_HOST_MEMORY: return {ErrorKind::kMachine, "device.memory", name + " ran out of memory", {}};
    default:
      return {ErrorKind::kMachine, "device.call", name + " failed with VkResult " + std::to_string(static_cast<int>(result)), {}};
  }
}

std::uint32_t memoryTypeIndex(const DeviceView& device, std::uint32_t bits, VkMemoryPropertyFlags wanted) {
  std::uint32_t fallback = 0;
  for (std::uint32_t index = device.memory.memoryTypeCount; index-- > 0;) {
    if ((bits & (1u << index)) == 0) continue;
    fallback = index;
  }
  for (std::uint32_t index = 0; index < device.memory.memoryTypeCount; ++index)
    if ((bits & (1u << index)) != 0 && (device.memory.memoryTypes[index].propertyFlags & wanted) == wanted) return index;
  return fallback;
}

}  // namespace reprise
