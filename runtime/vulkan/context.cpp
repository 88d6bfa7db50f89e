#include "runtime/vulkan/context.h"

#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstring>
#include <optional>

namespace reprise {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

Error noDevice(const std::string& found) {
  return {ErrorKind::kMachine, "device.none",
          "found no Vulkan device (" + found + "); install a driver, such as mesa-vulkan-drivers for a CPU device, or check "
          "VK_ICD_FILENAMES", {}};
}

VKAPI_ATTR VkBool32 VKAPI_CALL collectMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                              const VkDebugUtilsMessengerCallbackDataEXT* message, void* user) {
  static_cast<std::vector<std::string>*>(user)->push_back(message->pMessage);
  return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(std::vector<std::string>* messages) {
  VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT;
  info.pfnUserCallback = collectMessage;
  info.pUserData = messages;
  return info;
}

bool hasValidationLayer() {
  std::uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(),
                     [](const VkLayerProperties& layer) { return std::strcmp(layer.layerName, kValidationLayer) == 0; });
}

Result<VkInstance> createInstance(bool validation, std::vector<std::string>* messages) {
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "reprise";
  application.apiVersion = VK_API_VERSION_1_3;
  VkInstanceCreateInfo create{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  create.pApplicationInfo = &application;
  const VkValidationFeatureEnableEXT enabled[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = enabled;
  VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(messages);
  features.pNext = &messenger;
  const char* layers[] = {kValidationLayer};
  const char* extensions[] = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME};
  if (validation) {
    if (!hasValidationLayer())
      return Error{ErrorKind::kMachine, "device.validation",
                   std::string("the layer ") + kValidationLayer + " is not installed (Debian: vulkan-validationlayers)", {}};
    create.pNext = &features;
    create.enabledLayerCount = 1;
    create.ppEnabledLayerNames = layers;
    create.enabledExtensionCount = 1;
    create.ppEnabledExtensionNames = extensions;
  }
  VkInstance instance = VK_NULL_HANDLE;
  const VkResult result = vkCreateInstance(&create, nullptr, &instance);
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER) return noDevice("the loader found no driver");
  if (result != VK_SUCCESS) return vulkanError(result, "vkCreateInstance(");
  return instance;
}

std::string versionText(std::uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) + "." +
         std::to_string(VK_API_VERSION_PATCH(version));
}

DeviceSummary summarize(VkPhysicalDevice device, int index) {
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  properties.pNext = &driver;
  vkGetPhysicalDeviceProperties2(device, &properties);
  return {index, properties.properties.deviceName, std::string(driver.driverName) + ", " + driver.driverInfo,
          versionText(properties.properties.apiVersion), properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU};
}

Result<std::vector<VkPhysicalDevice>> physicalDevices(VkInstance instance) {
  std::uint32_t count = 0;
  REPRISE_VK(vkEnumeratePhysicalDevices(instance, &count, nullptr));
  std::vector<VkPhysicalDevice> devices(count);
  REPRISE_VK(vkEnumeratePhysicalDevices(instance, &count, devices.data()));
  if (devices.empty()) return noDevice("the drivers report none");
  return devices;
}

bool hasDynamicRendering(VkPhysicalDevice device) {
  VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  features.pNext = &features13;
  vkGetPhysicalDeviceFeatures2(device, &features);
  return features13.dynamicRendering == VK_TRUE;
}

// Where none is usable, the first: creating it says what it lacks.
int firstUsable(const std::vector<VkPhysicalDevice>& devices) {
  const auto found = std::find_if(devices.begin(), devices.end(), hasDynamicRendering);
  return found == devices.end() ? 0 : static_cast<int>(found - devices.begin());
}

Result<int> chooseDevice(const std::vector<DeviceSummary>& devices, const std::string& wanted) {
  // Names have digits, too.
  for (const DeviceSummary& device : devices)
    if (std::to_string(device.index) == wanted) return device.index;
  std::string known;
  for (const DeviceSummary& device : devices) {
    if (device.name.find(wanted) != std::string::npos) return device.index;
    known += (known.empty() ? "" : ", ") + std::to_string(device.index) + " '" + device.name + "'";
  }
  return Error{ErrorKind::kMachine, "device.unknown", "no Vulkan device matches '" + wanted + "'; there are " + known, {}};
}

std::optional<std::uint32_t> graphicsFamily(VkPhysicalDevice device, bool& has_timestamps) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  for (std::uint32_t family = 0; family < count; ++family)
    if ((families[family].queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0) {
      has_timestamps = families[family].timestampValidBits > 0;
      return family;
    }
  return std::nullopt;
}

Result<bool> hasConditionalRendering(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  REPRISE_VK(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr));
  std::vector<VkExtensionProperties> extensions(count);
  REPRISE_VK(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data()));
  if (std::none_of(extensions.begin(), extensions.end(), [](const VkExtensionProperties& one) {
        return std::string(one.extensionName) == VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME;
      }))
    return false;
  VkPhysicalDeviceConditionalRenderingFeaturesEXT conditional{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_CONDITIONAL_RENDERING_FEATURES_EXT};
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  features.pNext = &conditional;
  vkGetPhysicalDeviceFeatures2(device, &features);
  return conditional.conditionalRendering == VK_TRUE;
}

// Everything that a shader or a recipe under test may use is enabled where the device has it.
Result<VkDevice> createDevice(VkPhysicalDevice physical_device, std::uint32_t family, bool conditional_rendering) {
  VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceVulkan12Features features12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan11Features features11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  features.pNext = &features11;
  features11.pNext = &features12;
  features12.pNext = &features13;
  vkGetPhysicalDeviceFeatures2(physical_device, &features);
  if (features13.dynamicRendering == VK_FALSE)
    return Error{ErrorKind::kMachine, "device.feature", "the Vulkan device has no dynamic rendering (Vulkan 1.3)", {}};
  features.features.robustBufferAccess = VK_FALSE;
  features12.bufferDeviceAddressCaptureReplay = VK_FALSE;
  VkPhysicalDeviceConditionalRenderingFeaturesEXT conditional{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_CONDITIONAL_RENDERING_FEATURES_EXT};
  conditional.conditionalRendering = VK_TRUE;
  const char* const extension = VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME;
  const float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo create{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  create.pNext = &features;
  if (conditional_rendering) {
    features13.pNext = &conditional;
    create.enabledExtensionCount = 1;
    create.ppEnabledExtensionNames = &extension;
  }
  create.queueCreateInfoCount = 1;
  create.pQueueCreateInfos = &queue;
  VkDevice device = VK_NULL_HANDLE;
  REPRISE_VK(vkCreateDevice(physical_device, &create, nullptr, &device));
  return device;
}

}  // namespace

struct Context::State {
  std::vector<std::string> messages;
  VkInstance instance = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;
  std::uint32_t family = 0;
  double timestamp_period_ns = 1;
  bool has_timestamps = false;
  bool has_conditional_rendering = false;
  DeviceSummary summary;
  DeviceView view;

  ~State() {
    if (device != VK_NULL_HANDLE) vkDestroyDevice(device, nullptr);
    if (messenger != VK_NULL_HANDLE) {
      const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
          vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"));
      destroy(instance, messenger, nullptr);
    }
    if (instance != VK_NULL_HANDLE) vkDestroyInstance(instance, nullptr);
  }
};

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

const DeviceView& Context::view() const { return state_->view; }
const DeviceSummary& Context::summary() const { return state_->summary; }
VkInstance Context::instance() const { return state_->instance; }
VkQueue Context::queue() const { return state_->queue; }
std::uint32_t Context::queue_family() const { return state_->family; }
double Context::timestamp_period_ns() const { return state_->timestamp_period_ns; }
bool Context::has_timestamps() const { return state_->has_timestamps; }
bool Context::has_conditional_rendering() const { return state_->has_conditional_rendering; }
const std::vector<std::string>& Context::validation_messages() const { return state_->messages; }
FunctionSource Context::functions() const {
  return {state_->instance, state_->device, vkGetInstanceProcAddr, vkGetDeviceProcAddr};
}

Result<Context> Context::create(const ContextOptions& options) {
  auto state = std::make_unique<State>();
  REPRISE_ASSIGN(state->instance, createInstance(options.validation, &state->messages));
  if (options.validation) {
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(state->instance, "vkCreateDebugUtilsMessengerEXT"));
    const VkDebugUtilsMessengerCreateInfoEXT info = messengerInfo(&state->messages);
    REPRISE_VK(create(state->instance, &info, nullptr, &state->messenger));
  }
  REPRISE_ASSIGN(const std::vector<VkPhysicalDevice> devices, physicalDevices(state->instance));
  std::vector<DeviceSummary> summaries;
  for (std::size_t i = 0; i < devices.size(); ++i) summaries.push_back(summarize(devices[i], static_cast<int>(i)));
  int chosen = firstUsable(devices);
  if (!options.device.empty()) {
    REPRISE_ASSIGN(chosen, chooseDevice(summaries, options.device));
  }
  const VkPhysicalDevice physical_device = devices[static_cast<std::size_t>(chosen)];
  state->summary = summaries[static_cast<std::size_t>(chosen)];
  const auto family = graphicsFamily(physical_device, state->has_timestamps);
  if (!family) return noDevice("'" + state->summary.name + "' has no graphics queue");
  state->family = *family;
  REPRISE_ASSIGN(state->has_conditional_rendering, hasConditionalRendering(physical_device));
  REPRISE_ASSIGN(state->device, createDevice(physical_device, *family, state->has_conditional_rendering));
  vkGetDeviceQueue(state->device, *family, 0, &state->queue);
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physical_device, &properties);
  state->timestamp_period_ns = static_cast<double>(properties.limits.timestampPeriod);
  REPRISE_ASSIGN(state->view, viewDevice({state->instance, state->device, vkGetInstanceProcAddr, vkGetDeviceProcAddr}, physical_device));
  return Context(std::move(state));
}

Result<std::vector<DeviceSummary>> listDevices() {
  REPRISE_ASSIGN(const VkInstance instance, createInstance(false, nullptr));
  const Result<std::vector<VkPhysicalDevice>> devices = physicalDevices(instance);
  std::vector<DeviceSummary> summaries;
  if (devices.ok())
    for (std::size_t i = 0; i < devices->size(); ++i) summaries.push_back(summarize((*devices)[i], static_cast<int>(i)));
  vkDestroyInstance(instance, nullptr);
  if (!devices.ok()) return devices.error();
  return summaries;
}

}  // namespace reprise
