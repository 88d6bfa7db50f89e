#include "runtime/vulkan/functions.h"

namespace reprise {

Result<VulkanFunctions> loadFunctions(const FunctionSource& source) {
  if (source.device == VK_NULL_HANDLE || source.get_instance_proc_addr == nullptr || source.get_device_proc_addr == nullptr)
    return Error{ErrorKind::kMachine, "device.function",
                 "no Vulkan device, or no vkGetInstanceProcAddr and vkGetDeviceProcAddr, was given", {}};
  VulkanFunctions functions;
  std::string missing;
#define REPRISE_LOAD(name)                                                                                   \
  functions.name = reinterpret_cast<PFN_##name>(source.get_device_proc_addr(source.device, #name));          \
  if (functions.name == nullptr && missing.empty()) missing = #name;
  REPRISE_DEVICE_FUNCTIONS(REPRISE_LOAD)
#undef REPRISE_LOAD
#define REPRISE_LOAD(name)                                                                                   \
  functions.name = reinterpret_cast<PFN_##name>(source.get_device_proc_addr(source.device, #name));          \
  if (functions.name == nullptr)                                                                             \
    functions.name = reinterpret_cast<PFN_##name>(source.get_device_proc_addr(source.device, #name "KHR"));  \
  if (functions.name == nullptr && missing.empty()) missing = #name;
  REPRISE_DEVICE_FUNCTIONS_KHR(REPRISE_LOAD)
#undef REPRISE_LOAD
#define REPRISE_LOAD(name) functions.name = reinterpret_cast<PFN_##name>(source.get_device_proc_addr(source.device, #name));
  REPRISE_OPTIONAL_DEVICE_FUNCTIONS(REPRISE_LOAD)
#undef REPRISE_LOAD
#define REPRISE_LOAD(name)                                                                                   \
  functions.name = reinterpret_cast<PFN_##name>(source.get_instance_proc_addr(source.instance, #name));      \
  if (functions.name == nullptr && missing.empty()) missing = #name;
  REPRISE_INSTANCE_FUNCTIONS(REPRISE_LOAD)
#undef REPRISE_LOAD
  if (!missing.empty())
    return Error{ErrorKind::kMachine, "device.function",
                 "the Vulkan device has no " + missing + "; Reprise needs Vulkan 1.3 or VK_KHR_dynamic_rendering, enabled", {}};
  return functions;
}

}  // namespace reprise
