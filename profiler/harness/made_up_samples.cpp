#include "profiler/harness/made_up_samples.h"

#include <cmath>
#include <cstring>

namespace reprise {
namespace {

constexpr std::uint32_t kSide = 16, kLayers = 4;

// Copies cannot write several samples; clears of one texel each can.
void clearTexels(const DeviceView& device, VkCommandBuffer commands, const TexelFormat& format, bool depth, std::uint32_t layers,
                 MadeUpValues& values) {
  for (std::uint32_t layer = 0; layer < layers; ++layer) {
    const float phase = 6.28f * values.fraction();
    for (std::uint32_t y = 0; y < kSide; ++y)
      for (std::uint32_t x = 0; x < kSide; ++x) {
        const Texel texel = madeUpTexel(x, y, phase, format.channels, values);
        VkClearAttachment clear{depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT, 0, {}};
        if (depth) {
          clear.clearValue.depthStencil.depth = texel.values[0];
        } else if (format.coding == TexelFormat::kWhole) {
          std::memcpy(clear.clearValue.color.uint32, texel.wholes, sizeof texel.wholes);
        } else {
          std::memcpy(clear.clearValue.color.float32, texel.values, sizeof texel.values);
        }
        const VkClearRect place{{{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)}, {1, 1}}, layer, 1};
        device.fn.vkCmdClearAttachments(commands, 1, &clear, 1, &place);
      }
  }
}

}  // namespace

Texel madeUpTexel(std::uint32_t x, std::uint32_t y, float phase, std::size_t channels, MadeUpValues& values) {
  constexpr float kScale[] = {1, 2, 4, 1}, kOffset[] = {0, -1, 0, 0};  // by style
  const auto style = static_cast<std::size_t>(values.style());
  Texel texel{};
  for (std::size_t channel = 0; channel < channels; ++channel) {
    const float wave = 0.5f + 0.35f * std::sin(phase + 0.7f * static_cast<float>(x) + 0.5f * static_cast<float>(y) + static_cast<float>(channel));
    // A seed of the last style makes alpha tests pass.
    const bool opaque = channel == 3 && values.style() == MadeUpStyle::kCounts;
    texel.values[channel] = opaque ? 1.0f : kOffset[style] + kScale[style] * (wave + 0.15f * (values.fraction() - 0.5f));
    texel.wholes[channel] = values.whole();
  }
  return texel;
}

void changeWholeLayout(const DeviceView& device, VkCommandBuffer commands, const Image& image, VkImageAspectFlags aspect, VkImageLayout from,
                       VkImageLayout to) {
  VkImageMemoryBarrier change{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  change.srcAccessMask = change.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  change.oldLayout = from;
  change.newLayout = to;
  change.srcQueueFamilyIndex = change.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  change.image = image.image.get();
  change.subresourceRange = {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
  constexpr VkPipelineStageFlags kAll = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
  device.fn.vkCmdPipelineBarrier(commands, kAll, kAll, 0, 0, nullptr, 0, nullptr, 1, &change);
}

Result<Image> madeUpSamples(const Context& context, Commands& commands, const Descriptor& descriptor, const TexelFormat& format,
                            MadeUpValues& values) {
  if (descriptor.kind == DescriptorKind::kStorageImage)
    return Error{ErrorKind::kInput, "harness.unsupported", "no contents are made up for the multisampled storage image '" + descriptor.name + "'", {}};
  const DeviceView& device = context.view();
  const bool array = descriptor.dimension == ImageDimension::k2DArray, depth = descriptor.compares;
  const std::uint32_t layers = array ? kLayers : 1;
  const VkImageAspectFlags aspect = depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
  const VkImageUsageFlags attachment = depth ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  const VkImageLayout layout = depth ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL : VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  REPRISE_ASSIGN(Image image, createImage(device, {format.format, {kSide, kSide, 1}, layers, 1, VK_IMAGE_USAGE_SAMPLED_BIT | attachment, aspect,
                                                   array ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D, VK_SAMPLE_COUNT_4_BIT}));
  REPRISE_TRY(commands.run([&](VkCommandBuffer buffer) -> Result<void> {
    changeWholeLayout(device, buffer, image, aspect, VK_IMAGE_LAYOUT_UNDEFINED, layout);
    VkRenderingAttachmentInfo target{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    target.imageView = image.view.get();
    target.imageLayout = layout;
    target.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    target.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
    rendering.renderArea = {{0, 0}, {kSide, kSide}};
    rendering.layerCount = layers;
    rendering.colorAttachmentCount = depth ? 0 : 1;
    rendering.pColorAttachments = &target;
    rendering.pDepthAttachment = depth ? &target : nullptr;
    device.fn.vkCmdBeginRendering(buffer, &rendering);
    clearTexels(device, buffer, format, depth, layers, values);
    device.fn.vkCmdEndRendering(buffer);
    changeWholeLayout(device, buffer, image, aspect, layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    return {};
  }));
  return image;
}

}  // namespace reprise
