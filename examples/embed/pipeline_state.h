// The fixed-function state of the application's pipeline.
#pragma once

#include <vulkan/vulkan.h>

namespace embed {

// A VkGraphicsPipelineCreateInfo without stages, and all that it points to. Reprise derives its pipelines
// from it, so that a cached variant covers the very same pixels as the original. Shader stages, layout,
// viewport and scissor are the player's.
struct PipelineState {
  PipelineState();
  PipelineState(const PipelineState&) = delete;  // it points into itself
  PipelineState& operator=(const PipelineState&) = delete;

  VkVertexInputBindingDescription binding{};
  VkVertexInputAttributeDescription attributes[2] = {};
  VkPipelineVertexInputStateCreateInfo vertex_input{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  VkPipelineRasterizationStateCreateInfo raster{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  VkPipelineMultisampleStateCreateInfo samples{.sType =
                                                   VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  VkPipelineDepthStencilStateCreateInfo depth{.sType =
                                                  VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  VkPipelineColorBlendAttachmentState blend_attachment{};
  VkPipelineColorBlendStateCreateInfo blend{.sType =
                                                VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  VkGraphicsPipelineCreateInfo create_info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
};

}  // namespace embed
