#include "runtime/vulkan/readback.h"

#include <bit>
#include <cstring>

namespace reprise {
namespace {

struct FormatShape {
  std::uint32_t channels = 0;
  std::uint32_t bytes = 0;  // of a channel
  bool unorm = false;
  bool integer = false, is_signed = false;  // of 32 bits
};

FormatShape shapeOf(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R8_UNORM: return {1, 1, true};
    case VK_FORMAT_R8G8B8A8_UNORM:
    case VK_FORMAT_R8G8B8A8_SRGB: return {4, 1, true};
    case VK_FORMAT_R16G16_UNORM: return {2, 2, true};
    case VK_FORMAT_R16G16B16A16_UNORM: return {4, 2, true};
    case VK_FORMAT_R16_SFLOAT: return {1, 2};
    case VK_FORMAT_R16G16_SFLOAT: return {2, 2};
    case VK_FORMAT_R16G16B16A16_SFLOAT: return {4, 2};
    case VK_FORMAT_R32_SFLOAT:
    case VK_FORMAT_D32_SFLOAT: return {1, 4};
    case VK_FORMAT_R32G32B32A32_SFLOAT: return {4, 4};
    case VK_FORMAT_R32_UINT: return {1, 4, false, true};
    case VK_FORMAT_R32G32_UINT: return {2, 4, false, true};
    case VK_FORMAT_R32G32B32A32_UINT: return {4, 4, false, true};
    case VK_FORMAT_R32_SINT: return {1, 4, false, true, true};
    case VK_FORMAT_R32G32_SINT: return {2, 4, false, true, true};
    case VK_FORMAT_R32G32B32A32_SINT: return {4, 4, false, true, true};
    default: return {};
  }
}

float halfToFloat(std::uint16_t half) {
  const std::uint32_t sign = static_cast<std::uint32_t>(half & 0x8000) << 16;
  std::uint32_t exponent = (half >> 10) & 0x1f, mantissa = half & 0x3ff;
  if (exponent == 31) return std::bit_cast<float>(sign | 0x7f800000u | (mantissa << 13));
  if (exponent == 0) return std::bit_cast<float>(sign | std::bit_cast<std::uint32_t>(static_cast<float>(mantissa) * 0x1p-24f));
  return std::bit_cast<float>(sign | ((exponent + 112) << 23) | (mantissa << 13));
}

float channelAt(const std::byte* at, const FormatShape& shape) {
  if (shape.bytes == 1) return static_cast<float>(std::to_integer<int>(*at)) / 255.0f;
  if (shape.bytes == 2) {
    std::uint16_t bits;
    std::memcpy(&bits, at, 2);
    return shape.unorm ? static_cast<float>(bits) / 65535.0f : halfToFloat(bits);
  }
  std::uint32_t bits;
  std::memcpy(&bits, at, 4);
  if (!shape.integer) return std::bit_cast<float>(bits);
  return shape.is_signed ? static_cast<float>(static_cast<std::int32_t>(bits)) : static_cast<float>(bits);
}

}  // namespace

std::uint32_t formatBytes(VkFormat format) {
  const FormatShape shape = shapeOf(format);
  return shape.channels * shape.bytes;
}

Result<std::span<const std::byte>> Readback::read(Commands& commands, const ReadbackSource& source) {
  const DeviceView& device = context_->view();
  const std::size_t size = static_cast<std::size_t>(source.extent.width) * source.extent.height * formatBytes(source.format);
  if (size == 0) return Error{ErrorKind::kMachine, "readback.format", "an image of this format cannot be read back", {}};
  if (staging_.mapped.size() < size) {
    REPRISE_ASSIGN(staging_, createBuffer(device, size, VK_BUFFER_USAGE_TRANSFER_DST_BIT));
  }
  const VkImageAspectFlags aspect =
      source.format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
  REPRISE_TRY(commands.run([&](VkCommandBuffer buffer) -> Result<void> {
    changeLayout(device, buffer, {source.image, source.layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, aspect});
    VkBufferImageCopy copy{};
    copy.imageSubresource = {aspect, 0, 0, 1};
    copy.imageExtent = {source.extent.width, source.extent.height, 1};
    device.fn.vkCmdCopyImageToBuffer(buffer, source.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, staging_.buffer.get(), 1, &copy);
    changeLayout(device, buffer, {source.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, source.layout, aspect});
    VkMemoryBarrier to_host{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_TRANSFER_WRITE_BIT, VK_ACCESS_HOST_READ_BIT};
    device.fn.vkCmdPipelineBarrier(buffer, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &to_host, 0,
                                   nullptr, 0, nullptr);
    return {};
  }));
  return std::span<const std::byte>(staging_.mapped.data(), size);
}

std::vector<float> toFloats(std::span<const std::byte> bytes, VkFormat format) {
  const FormatShape shape = shapeOf(format);
  REPRISE_CHECK(shape.channels > 0, static_cast<int>(format));
  const std::size_t pixels = bytes.size() / (shape.channels * shape.bytes);
  std::vector<float> rgba(pixels * 4);
  const std::byte* at = bytes.data();
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    float* out = &rgba[pixel * 4];
    out[0] = out[1] = out[2] = 0;
    out[3] = 1;
    for (std::uint32_t channel = 0; channel < shape.channels; ++channel, at += shape.bytes) out[channel] = channelAt(at, shape);
  }
  return rgba;
}

}  // namespace reprise
