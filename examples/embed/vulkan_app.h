// The application's own Vulkan: an instance, a device, memory. Nothing in here knows of Reprise; it stands
// for whatever an application already has.
#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <vector>

namespace embed {

// Throws std::runtime_error("what failed (VkResult n)") unless result is VK_SUCCESS.
void check(VkResult result, const char* what);

struct Buffer {
  VkBuffer handle = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  void* mapped = nullptr;  // host-visible and coherent
};

struct Image {
  VkImage handle = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
};

// Device-local image with one mip level, one layer, and a view of `aspect`.
struct ImageSpec {
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent = {};
  VkImageUsageFlags usage = 0;
  VkImageAspectFlags aspect = 0;
};

// Owns the device and everything that was made through it, which dies with it.
class VulkanApp {
 public:
  VulkanApp();
  ~VulkanApp();
  VulkanApp(const VulkanApp&) = delete;
  VulkanApp& operator=(const VulkanApp&) = delete;

  VkInstance instance() const { return instance_; }
  VkPhysicalDevice physicalDevice() const { return physical_device_; }
  VkDevice device() const { return device_; }
  std::string deviceName() const;

  Buffer createBuffer(VkDeviceSize size_bytes, VkBufferUsageFlags usage);
  Image createImage(const ImageSpec& spec);

  // The one command buffer. begin() starts it, submitAndWait() runs it and returns when the device is done.
  VkCommandBuffer begin();
  void submitAndWait();

 private:
  void createInstance();
  void createDevice();
  VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties);

  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_device_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  std::uint32_t queue_family_ = 0;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  std::vector<Buffer> buffers_;
  std::vector<Image> images_;
};

}  // namespace embed
