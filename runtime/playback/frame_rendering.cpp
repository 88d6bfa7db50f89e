#include "runtime/playback/frame_rendering.h"

#include <algorithm>

#include "runtime/playback/formats.h"

namespace reprise {
namespace {

VkAttachmentLoadOp vulkanLoad(LoadOp load) {
  switch (load) {
    case LoadOp::kClear: return VK_ATTACHMENT_LOAD_OP_CLEAR;
    case LoadOp::kLoad: return VK_ATTACHMENT_LOAD_OP_LOAD;
    case LoadOp::kDontCare: return VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  }
  return VK_ATTACHMENT_LOAD_OP_LOAD;
}

VkAttachmentLoadOp loadOrClear(bool load) { return load ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR; }

void describeAppTarget(const ColorAttachment& color, RenderingParts& parts, VkRenderingAttachmentInfo& info) {
  const ColorTarget& target = parts.inputs->colors[static_cast<std::size_t>(color.app_target)];
  info.imageView = target.view;
  info.imageLayout = target.layout;
  info.loadOp = loadOrClear(target.load || parts.used_targets.count(color.app_target) != 0);
  info.clearValue.color = target.clear;
  parts.used_targets.insert(color.app_target);
}

void describeResource(const ColorAttachment& color, const RenderingParts& parts, VkRenderingAttachmentInfo& info) {
  ResourceImages& resource = parts.images->at(color.resource);
  info.imageView = resource.written(parts.frame).image.view.get();
  info.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  info.loadOp = vulkanLoad(color.load);
  std::copy(resource.resource.clear.begin(), resource.resource.clear.end(), info.clearValue.color.float32);
}

std::vector<VkRenderingAttachmentInfo> colorAttachments(const Pass& pass, RenderingParts& parts) {
  std::vector<VkRenderingAttachmentInfo> colors;
  for (const ColorAttachment& color : pass.colors) {
    const auto location = static_cast<std::size_t>(color.location);
    while (colors.size() <= location) colors.push_back({VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO});
    colors[location].storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    if (color.resource.empty()) describeAppTarget(color, parts, colors[location]);
    else describeResource(color, parts, colors[location]);
  }
  return colors;
}

}  // namespace

void beginRendering(const DeviceView& device, VkCommandBuffer commands, const Pass& pass, RenderingParts& parts) {
  const FrameInputs& inputs = *parts.inputs;
  const std::vector<VkRenderingAttachmentInfo> colors = colorAttachments(pass, parts);
  VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  depth.imageView = inputs.depth.view;
  depth.imageLayout = inputs.depth.layout;
  depth.loadOp = loadOrClear(inputs.depth.load || !pass.depth_clear);
  depth.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  depth.clearValue.depthStencil = {inputs.depth.clear_depth, 0};
  VkRenderingAttachmentInfo stencil = depth;
  if (!parts.depth_used && parts.marks_stencil) stencil.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  parts.depth_used = true;
  VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
  rendering.renderArea = {{0, 0}, inputs.extent};
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = static_cast<std::uint32_t>(colors.size());
  rendering.pColorAttachments = colors.data();
  rendering.pDepthAttachment = parts.depth_format != VK_FORMAT_UNDEFINED ? &depth : nullptr;
  rendering.pStencilAttachment = hasStencil(parts.depth_format) ? &stencil : nullptr;
  device.fn.vkCmdBeginRendering(commands, &rendering);
  device.fn.vkCmdSetViewport(commands, 0, 1, &inputs.viewport);
  const VkRect2D scissor{{0, 0}, inputs.extent};
  device.fn.vkCmdSetScissor(commands, 0, 1, &scissor);
}

}  // namespace reprise
