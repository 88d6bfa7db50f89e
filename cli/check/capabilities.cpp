#include "cli/check/capabilities.h"

#include <vulkan/vulkan_core.h>

#include "compiler/source/capability_names.h"

namespace reprise {
namespace {

struct Features {
  VkPhysicalDeviceVulkan11Features v11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
  VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceFeatures core{};
};

// Names without "Capability" as in the specification's table of required features; those of every Vulkan device are true.
bool has(const Features& features, const std::string& name) {
  const VkPhysicalDeviceFeatures& core = features.core;
  const std::pair<const char*, VkBool32> known[] = {
      {"Matrix", VK_TRUE}, {"Shader", VK_TRUE}, {"InputAttachment", VK_TRUE}, {"Sampled1D", VK_TRUE}, {"Image1D", VK_TRUE},
      {"SampledBuffer", VK_TRUE}, {"ImageBuffer", VK_TRUE}, {"ImageQuery", VK_TRUE}, {"DerivativeControl", VK_TRUE},
      {"StorageImageExtendedFormats", VK_TRUE}, {"SampledRect", VK_FALSE}, {"VariablePointers", features.v11.variablePointers},
      {"VariablePointersStorageBuffer", features.v11.variablePointersStorageBuffer}, {"DrawParameters", features.v11.shaderDrawParameters},
      {"MultiView", features.v11.multiview}, {"DeviceGroup", VK_TRUE}, {"Geometry", core.geometryShader},
      {"Tessellation", core.tessellationShader}, {"Float64", core.shaderFloat64}, {"Int64", core.shaderInt64}, {"Int16", core.shaderInt16},
      {"Float16", features.v12.shaderFloat16}, {"Int8", features.v12.shaderInt8}, {"ImageGatherExtended", core.shaderImageGatherExtended},
      {"StorageImageReadWithoutFormat", core.shaderStorageImageReadWithoutFormat},
      {"StorageImageWriteWithoutFormat", core.shaderStorageImageWriteWithoutFormat},
      {"StorageImageMultisample", core.shaderStorageImageMultisample},
      {"UniformBufferArrayDynamicIndexing", core.shaderUniformBufferArrayDynamicIndexing},
      {"SampledImageArrayDynamicIndexing", core.shaderSampledImageArrayDynamicIndexing},
      {"StorageBufferArrayDynamicIndexing", core.shaderStorageBufferArrayDynamicIndexing},
      {"StorageImageArrayDynamicIndexing", core.shaderStorageImageArrayDynamicIndexing}, {"ClipDistance", core.shaderClipDistance},
      {"CullDistance", core.shaderCullDistance}, {"ImageCubeArray", core.imageCubeArray}, {"SampledCubeArray", core.imageCubeArray},
      {"MinLod", core.shaderResourceMinLod}, {"MultiViewport", core.multiViewport}, {"ImageMSArray", core.shaderStorageImageMultisample}, {"InterpolationFunction", core.sampleRateShading}, {"SampleRateShading", core.sampleRateShading},
      {"SparseResidency", core.shaderResourceResidency}, {"StorageBuffer16BitAccess", features.v11.storageBuffer16BitAccess},
      {"UniformAndStorageBuffer16BitAccess", features.v11.uniformAndStorageBuffer16BitAccess},
      {"StoragePushConstant16", features.v11.storagePushConstant16}, {"StorageInputOutput16", features.v11.storageInputOutput16},
      {"StorageBuffer8BitAccess", features.v12.storageBuffer8BitAccess},
      {"UniformAndStorageBuffer8BitAccess", features.v12.uniformAndStorageBuffer8BitAccess},
      {"StoragePushConstant8", features.v12.storagePushConstant8}, {"ShaderNonUniform", features.v12.shaderSampledImageArrayNonUniformIndexing},
      {"RuntimeDescriptorArray", features.v12.runtimeDescriptorArray},
      {"SampledImageArrayNonUniformIndexing", features.v12.shaderSampledImageArrayNonUniformIndexing},
      {"UniformBufferArrayNonUniformIndexing", features.v12.shaderUniformBufferArrayNonUniformIndexing},
      {"StorageBufferArrayNonUniformIndexing", features.v12.shaderStorageBufferArrayNonUniformIndexing},
      {"StorageImageArrayNonUniformIndexing", features.v12.shaderStorageImageArrayNonUniformIndexing},
      {"UniformTexelBufferArrayDynamicIndexing", features.v12.shaderUniformTexelBufferArrayDynamicIndexing},
      {"VulkanMemoryModel", features.v12.vulkanMemoryModel}, {"VulkanMemoryModelDeviceScope", features.v12.vulkanMemoryModelDeviceScope},
      {"PhysicalStorageBufferAddresses", VK_FALSE},  // no made-up value is an address
      {"DemoteToHelperInvocation", features.v13.shaderDemoteToHelperInvocation}, {"GroupNonUniform", VK_TRUE},
      {"GroupNonUniformVote", VK_TRUE}, {"GroupNonUniformArithmetic", VK_TRUE}, {"GroupNonUniformBallot", VK_TRUE},
      {"GroupNonUniformShuffle", VK_TRUE}, {"GroupNonUniformShuffleRelative", VK_TRUE}, {"GroupNonUniformClustered", VK_TRUE},
      {"GroupNonUniformQuad", VK_TRUE}, {"ShaderLayer", features.v12.shaderOutputLayer}, {"ShaderViewportIndex", features.v12.shaderOutputViewportIndex}};
  for (const auto& [known_name, present] : known)
    if (name == known_name) return present == VK_TRUE;
  return false;
}

Features featuresOf(const Context& context) {
  Features found;
  VkPhysicalDeviceFeatures2 all{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  all.pNext = &found.v11;
  found.v11.pNext = &found.v12;
  found.v12.pNext = &found.v13;
  context.view().fn.vkGetPhysicalDeviceFeatures2(context.view().physical_device, &all);
  found.core = all.features;
  return found;
}

}  // namespace

std::string missingCapability(std::span<const std::uint32_t> words, const Context& context) {
  const Features features = featuresOf(context);
  for (const std::string& name : capabilityNames(words))
    if (!has(features, name)) return name;
  return "";
}

}  // namespace reprise
