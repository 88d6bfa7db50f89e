#include "runtime/playback/formats.h"

namespace reprise {

VkFormat vulkanFormat(ResourceFormat format) {
  switch (format) {
    case ResourceFormat::kRgba8Unorm: return VK_FORMAT_R8G8B8A8_UNORM;
    case ResourceFormat::kRg16Unorm: return VK_FORMAT_R16G16_UNORM;
    case ResourceFormat::kRgba16Unorm: return VK_FORMAT_R16G16B16A16_UNORM;
    case ResourceFormat::kRg16Sfloat: return VK_FORMAT_R16G16_SFLOAT;
    case ResourceFormat::kRgba16Sfloat: return VK_FORMAT_R16G16B16A16_SFLOAT;
    case ResourceFormat::kRgba32Sfloat: return VK_FORMAT_R32G32B32A32_SFLOAT;
    case ResourceFormat::kR32Uint: return VK_FORMAT_R32_UINT;
    case ResourceFormat::kRg32Uint: return VK_FORMAT_R32G32_UINT;
    case ResourceFormat::kRgba32Uint: return VK_FORMAT_R32G32B32A32_UINT;
    case ResourceFormat::kR8Unorm: return VK_FORMAT_R8_UNORM;
    case ResourceFormat::kR16Sfloat: return VK_FORMAT_R16_SFLOAT;
    case ResourceFormat::kR32Sfloat: return VK_FORMAT_R32_SFLOAT;
  }
  return VK_FORMAT_UNDEFINED;
}

VkDescriptorType descriptorType(DescriptorKind kind) {
  switch (kind) {
    case DescriptorKind::kUniformBlock: return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case DescriptorKind::kStorageBlock: return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case DescriptorKind::kCombinedImageSampler: return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case DescriptorKind::kSampledImage: return VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
    case DescriptorKind::kSampler: return VK_DESCRIPTOR_TYPE_SAMPLER;
    case DescriptorKind::kStorageImage: return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case DescriptorKind::kUniformTexelBuffer: return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    case DescriptorKind::kStorageTexelBuffer: return VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER;
  }
  return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
}

bool hasStencil(VkFormat format) {
  return format == VK_FORMAT_D32_SFLOAT_S8_UINT || format == VK_FORMAT_D24_UNORM_S8_UINT || format == VK_FORMAT_D16_UNORM_S8_UINT;
}

}  // namespace reprise
