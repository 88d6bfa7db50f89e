#include "vulkan_app.h"

#include <stdexcept>

namespace embed {

void check(VkResult result, const char* what) {
  if (result != VK_SUCCESS) {
    throw std::runtime_error(std::string(what) + " (VkResult " + std::to_string(result) + ")");
  }
}

VulkanApp::VulkanApp() {
  createInstance();
  createDevice();
  vkGetDeviceQueue(device_, queue_family_, 0, &queue_);

  VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool_info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool_info.queueFamilyIndex = queue_family_;
  check(vkCreateCommandPool(device_, &pool_info, nullptr, &pool_), "no command pool");

  VkCommandBufferAllocateInfo buffer_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  buffer_info.commandPool = pool_;
  buffer_info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  buffer_info.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(device_, &buffer_info, &commands_), "no command buffer");

  const VkFenceCreateInfo fence_info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  check(vkCreateFence(device_, &fence_info, nullptr, &fence_), "no fence");
}

VulkanApp::~VulkanApp() {
  vkDeviceWaitIdle(device_);
  for (const Image& image : images_) {
    vkDestroyImageView(device_, image.view, nullptr);
    vkDestroyImage(device_, image.handle, nullptr);
    vkFreeMemory(device_, image.memory, nullptr);
  }
  for (const Buffer& buffer : buffers_) {
    vkDestroyBuffer(device_, buffer.handle, nullptr);
    vkFreeMemory(device_, buffer.memory, nullptr);
  }
  vkDestroyFence(device_, fence_, nullptr);
  vkDestroyCommandPool(device_, pool_, nullptr);
  vkDestroyDevice(device_, nullptr);
  vkDestroyInstance(instance_, nullptr);
}

void VulkanApp::createInstance() {
  VkApplicationInfo app_info{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO};
  app_info.pApplicationName = "embed";
  app_info.apiVersion = VK_API_VERSION_1_3;
  VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &app_info;
  check(vkCreateInstance(&info, nullptr, &instance_), "no Vulkan instance");
}

void VulkanApp::createDevice() {
  std::uint32_t count = 1;
  vkEnumeratePhysicalDevices(instance_, &count, &physical_device_);  // the first will do
  if (count == 0) throw std::runtime_error("no Vulkan device");

  std::uint32_t family_count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical_device_, &family_count, nullptr);
  std::vector<VkQueueFamilyProperties> families(family_count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical_device_, &family_count, families.data());
  while (queue_family_ < family_count && !(families[queue_family_].queueFlags & VK_QUEUE_GRAPHICS_BIT)) {
    ++queue_family_;
  }
  if (queue_family_ == family_count) throw std::runtime_error("no queue for graphics");

  // What Reprise asks of the application's device: dynamic rendering and synchronization2, both core in
  // Vulkan 1.3. Independent blending is optional: without it, a package that needs it plays its original.
  VkPhysicalDeviceFeatures supported{};
  vkGetPhysicalDeviceFeatures(physical_device_, &supported);
  VkPhysicalDeviceVulkan13Features features13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  features13.dynamicRendering = VK_TRUE;
  features13.synchronization2 = VK_TRUE;
  VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2,
                                     .pNext = &features13};
  features.features.independentBlend = supported.independentBlend;

  const float priority = 1;
  VkDeviceQueueCreateInfo queue_info{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue_info.queueFamilyIndex = queue_family_;
  queue_info.queueCount = 1;
  queue_info.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .pNext = &features};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue_info;
  check(vkCreateDevice(physical_device_, &info, nullptr, &device_), "no Vulkan 1.3 device");
}

std::string VulkanApp::deviceName() const {
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical_device_, &properties);
  return properties.deviceName;
}

VkDeviceMemory VulkanApp::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties) {
  VkPhysicalDeviceMemoryProperties memory{};
  vkGetPhysicalDeviceMemoryProperties(physical_device_, &memory);
  for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
    const bool allowed = needs.memoryTypeBits & (1u << type);
    if (!allowed || (memory.memoryTypes[type].propertyFlags & properties) != properties) continue;
    VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = needs.size;
    info.memoryTypeIndex = type;
    VkDeviceMemory allocation = VK_NULL_HANDLE;
    check(vkAllocateMemory(device_, &info, nullptr, &allocation), "no memory");
    return allocation;
  }
  throw std::runtime_error("no fitting kind of memory");
}

Buffer VulkanApp::createBuffer(VkDeviceSize size_bytes, VkBufferUsageFlags usage) {
  Buffer& buffer = buffers_.emplace_back();
  VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = size_bytes;
  info.usage = usage;
  check(vkCreateBuffer(device_, &info, nullptr, &buffer.handle), "no buffer");
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(device_, buffer.handle, &needs);
  buffer.memory = allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  check(vkBindBufferMemory(device_, buffer.handle, buffer.memory, 0), "buffer memory not bound");
  check(vkMapMemory(device_, buffer.memory, 0, VK_WHOLE_SIZE, 0, &buffer.mapped), "buffer not mapped");
  return buffer;
}

Image VulkanApp::createImage(const ImageSpec& spec) {
  Image& image = images_.emplace_back();
  VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = spec.format;
  info.extent = {spec.extent.width, spec.extent.height, 1};
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = spec.usage;
  check(vkCreateImage(device_, &info, nullptr, &image.handle), "no image");
  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(device_, image.handle, &needs);
  image.memory = allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  check(vkBindImageMemory(device_, image.handle, image.memory, 0), "image memory not bound");

  VkImageViewCreateInfo view_info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view_info.image = image.handle;
  view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view_info.format = spec.format;
  view_info.subresourceRange = {spec.aspect, 0, 1, 0, 1};
  check(vkCreateImageView(device_, &view_info, nullptr, &image.view), "no image view");
  return image;
}

VkCommandBuffer VulkanApp::begin() {
  check(vkResetCommandBuffer(commands_, 0), "command buffer not reset");
  VkCommandBufferBeginInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &info), "command buffer not begun");
  return commands_;
}

void VulkanApp::submitAndWait() {
  check(vkEndCommandBuffer(commands_), "command buffer not ended");
  VkSubmitInfo info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO};
  info.commandBufferCount = 1;
  info.pCommandBuffers = &commands_;
  check(vkQueueSubmit(queue_, 1, &info, fence_), "not submitted");
  check(vkWaitForFences(device_, 1, &fence_, VK_TRUE, UINT64_MAX), "the device did not finish");
  check(vkResetFences(device_, 1, &fence_), "fence not reset");
}

}  // namespace embed
