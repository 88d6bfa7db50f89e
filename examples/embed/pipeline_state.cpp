#include "pipeline_state.h"

#include <cstddef>

#include "scene.h"

namespace embed {

PipelineState::PipelineState() {
  binding = {0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
  attributes[0] = {0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)};
  attributes[1] = {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)};
  vertex_input.vertexBindingDescriptionCount = 1;
  vertex_input.pVertexBindingDescriptions = &binding;
  vertex_input.vertexAttributeDescriptionCount = 2;
  vertex_input.pVertexAttributeDescriptions = attributes;
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  raster.polygonMode = VK_POLYGON_MODE_FILL;
  raster.cullMode = VK_CULL_MODE_NONE;  // the plates are seen from both sides
  raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  raster.lineWidth = 1;
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  depth.depthTestEnable = VK_TRUE;
  depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = VK_COMPARE_OP_LESS;
  blend_attachment.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                    VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  blend.attachmentCount = 1;
  blend.pAttachments = &blend_attachment;
  create_info.pVertexInputState = &vertex_input;
  create_info.pInputAssemblyState = &assembly;
  create_info.pRasterizationState = &raster;
  create_info.pMultisampleState = &samples;
  create_info.pDepthStencilState = &depth;
  create_info.pColorBlendState = &blend;
}

}  // namespace embed
