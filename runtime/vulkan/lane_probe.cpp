#include "runtime/vulkan/lane_probe.h"

#include <array>
#include <cstring>
#include <span>
#include <vector>

#include "runtime/vulkan/buffer.h"
#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/image.h"
#include "runtime/vulkan/probe/lanes.frag.h"
#include "runtime/vulkan/probe/lanes.vert.h"

namespace reprise {
namespace {

constexpr std::uint32_t kEdge = 16;
constexpr VkFormat kColor = VK_FORMAT_R8G8B8A8_UNORM, kDepth = VK_FORMAT_D16_UNORM;
// Pixels, each with a neighbour beside it and one below it in its quad.
constexpr std::uint32_t kRejected[] = {3, 2}, kDiscarded[] = {7, 2};

struct Pipeline {
  Handle<VkDescriptorSetLayout> set_layout;
  Handle<VkPipelineLayout> layout;
  Handle<VkDescriptorPool> pool;
  VkDescriptorSet set = VK_NULL_HANDLE;
  Handle<VkPipeline> pipeline;
};

Result<Handle<VkShaderModule>> createModule(const DeviceView& device, std::span<const std::uint32_t> words) {
  VkShaderModuleCreateInfo create{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  create.codeSize = words.size_bytes();
  create.pCode = words.data();
  VkShaderModule module = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateShaderModule(device.device, &create, nullptr, &module));
  return Handle<VkShaderModule>{device.device, module, device.fn.vkDestroyShaderModule};
}

Result<void> createLayouts(const DeviceView& device, Pipeline& made) {
  const VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo set_create{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  set_create.bindingCount = 1;
  set_create.pBindings = &binding;
  VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateDescriptorSetLayout(device.device, &set_create, nullptr, &set_layout));
  made.set_layout = {device.device, set_layout, device.fn.vkDestroyDescriptorSetLayout};
  VkPipelineLayoutCreateInfo layout_create{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout_create.setLayoutCount = 1;
  layout_create.pSetLayouts = &set_layout;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreatePipelineLayout(device.device, &layout_create, nullptr, &layout));
  made.layout = {device.device, layout, device.fn.vkDestroyPipelineLayout};
  return {};
}

Result<void> createSet(const DeviceView& device, const Buffer& values, Pipeline& made) {
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1};
  VkDescriptorPoolCreateInfo pool_create{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool_create.maxSets = 1;
  pool_create.poolSizeCount = 1;
  pool_create.pPoolSizes = &size;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateDescriptorPool(device.device, &pool_create, nullptr, &pool));
  made.pool = {device.device, pool, device.fn.vkDestroyDescriptorPool};
  const VkDescriptorSetLayout set_layout = made.set_layout.get();
  VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool;
  allocate.descriptorSetCount = 1;
  allocate.pSetLayouts = &set_layout;
  REPRISE_VK(device.fn.vkAllocateDescriptorSets(device.device, &allocate, &made.set));
  const VkDescriptorBufferInfo info{values.buffer.get(), 0, VK_WHOLE_SIZE};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = made.set;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  write.pBufferInfo = &info;
  device.fn.vkUpdateDescriptorSets(device.device, 1, &write, 0, nullptr);
  return {};
}

// Depth LESS with writes, viewport and scissor of the whole target.
Result<void> createPipeline(const DeviceView& device, Pipeline& made) {
  REPRISE_ASSIGN(const Handle<VkShaderModule> vertex, createModule(device, kLanesVertex));
  REPRISE_ASSIGN(const Handle<VkShaderModule> fragment, createModule(device, kLanesFragment));
  VkPipelineShaderStageCreateInfo stages[2] = {{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO}, {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO}};
  stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
  stages[0].module = vertex.get();
  stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
  stages[1].module = fragment.get();
  stages[0].pName = stages[1].pName = "main";
  const VkPipelineVertexInputStateCreateInfo vertex_input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  const VkViewport viewport{0, 0, kEdge, kEdge, 0, 1};
  const VkRect2D scissor{{0, 0}, {kEdge, kEdge}};
  VkPipelineViewportStateCreateInfo viewports{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewports.viewportCount = viewports.scissorCount = 1;
  viewports.pViewports = &viewport;
  viewports.pScissors = &scissor;
  VkPipelineRasterizationStateCreateInfo rasterization{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  rasterization.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo multisample{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = VK_COMPARE_OP_LESS;
  VkPipelineColorBlendAttachmentState attachment{};
  attachment.colorWriteMask = 0xf;
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = 1;
  blend.pAttachments = &attachment;
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = 1;
  rendering.pColorAttachmentFormats = &kColor;
  rendering.depthAttachmentFormat = kDepth;
  VkGraphicsPipelineCreateInfo create{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  create.pNext = &rendering;
  create.stageCount = 2;
  create.pStages = stages;
  create.pVertexInputState = &vertex_input;
  create.pInputAssemblyState = &assembly;
  create.pViewportState = &viewports;
  create.pRasterizationState = &rasterization;
  create.pMultisampleState = &multisample;
  create.pDepthStencilState = &depth;
  create.pColorBlendState = &blend;
  create.layout = made.layout.get();
  VkPipeline pipeline = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateGraphicsPipelines(device.device, VK_NULL_HANDLE, 1, &create, nullptr, &pipeline));
  made.pipeline = {device.device, pipeline, device.fn.vkDestroyPipeline};
  return {};
}

struct Targets {
  Image color, depth;
  Buffer values, pixels;
};

Result<Targets> createTargets(const DeviceView& device) {
  Targets targets;
  ImageDescription description;
  description.extent = {kEdge, kEdge, 1};
  description.format = kColor;
  description.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  REPRISE_ASSIGN(targets.color, createImage(device, description));
  description.format = kDepth;
  description.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  description.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
  REPRISE_ASSIGN(targets.depth, createImage(device, description));
  std::array<float, kEdge * kEdge> ones;
  ones.fill(1);
  REPRISE_ASSIGN(targets.values, createBuffer(device, sizeof ones, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
  std::memcpy(targets.values.mapped.data(), ones.data(), sizeof ones);
  REPRISE_ASSIGN(targets.pixels, createBuffer(device, VkDeviceSize{4} * kEdge * kEdge, VK_BUFFER_USAGE_TRANSFER_DST_BIT));
  return targets;
}

void recordDraw(const DeviceView& device, VkCommandBuffer commands, const Pipeline& pipeline, const Targets& targets) {
  VkRenderingAttachmentInfo color{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  color.imageView = targets.color.view.get();
  color.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  color.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  VkRenderingAttachmentInfo depth = color;
  depth.imageView = targets.depth.view.get();
  depth.imageLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
  depth.clearValue.depthStencil.depth = 1;
  VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
  rendering.renderArea.extent = {kEdge, kEdge};
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = 1;
  rendering.pColorAttachments = &color;
  rendering.pDepthAttachment = &depth;
  device.fn.vkCmdBeginRendering(commands, &rendering);
  VkClearAttachment near{VK_IMAGE_ASPECT_DEPTH_BIT, 0, {}};
  const VkClearRect pixel{{{static_cast<std::int32_t>(kRejected[0]), static_cast<std::int32_t>(kRejected[1])}, {1, 1}}, 0, 1};
  device.fn.vkCmdClearAttachments(commands, 1, &near, 1, &pixel);
  device.fn.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.pipeline.get());
  device.fn.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.layout.get(), 0, 1, &pipeline.set, 0, nullptr);
  device.fn.vkCmdDraw(commands, 3, 1, 0, 0);
  device.fn.vkCmdEndRendering(commands);
}

void recordCopy(const DeviceView& device, VkCommandBuffer commands, const Targets& targets) {
  changeLayout(device, commands, {targets.color.image.get(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_ASPECT_COLOR_BIT});
  VkBufferImageCopy copy{};
  copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  copy.imageExtent = {kEdge, kEdge, 1};
  device.fn.vkCmdCopyImageToBuffer(commands, targets.color.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, targets.pixels.buffer.get(), 1, &copy);
}

class Picture {
 public:
  explicit Picture(std::span<const std::byte> pixels) : pixels_(pixels) {}

  bool drawn(std::uint32_t x, std::uint32_t y) const { return channel(x, y, 3) != 0; }
  bool same(std::uint32_t x, std::uint32_t y) const { return channel(x, y, 0) == 0 && channel(x, y, 1) == 0; }

  // Of a quad that lacks this pixel, which is its upper right one: whether its neighbours got what it loaded.
  bool loads(const std::uint32_t (&lacking)[2]) const {
    const std::uint32_t x = lacking[0], y = lacking[1];
    return !drawn(x, y) && drawn(x - 1, y) && drawn(x, y + 1) && same(x - 1, y) && same(x, y + 1);
  }

  // Of the quads along the triangle's long edge.
  bool helpersLoad() const {
    bool seen = false, all_same = true;
    for (std::uint32_t y = 0; y < kEdge; ++y)
      for (std::uint32_t x = 0; x < kEdge; ++x) {
        if ((x / 2 + y / 2) != kEdge / 2 - 1 || !drawn(x, y)) continue;
        seen = seen || !drawn(x ^ 1u, y) || !drawn(x, y ^ 1u);
        all_same = all_same && same(x, y);
      }
    return seen && all_same;
  }

 private:
  int channel(std::uint32_t x, std::uint32_t y, std::size_t index) const { return std::to_integer<int>(pixels_[4 * (x + std::size_t{kEdge} * y) + index]); }

  std::span<const std::byte> pixels_;
};

}  // namespace

Result<LaneLoads> probeLanes(const ProbedDevice& probed) {
  REPRISE_ASSIGN(const DeviceView device, viewDevice({probed.instance, probed.device, probed.get_instance_proc_addr, probed.get_device_proc_addr}, probed.physical_device));
  REPRISE_ASSIGN(Commands commands, Commands::create(device, probed.queue, probed.queue_family));
  REPRISE_ASSIGN(const Targets targets, createTargets(device));
  Pipeline pipeline;
  REPRISE_TRY(createLayouts(device, pipeline));
  REPRISE_TRY(createSet(device, targets.values, pipeline));
  REPRISE_TRY(createPipeline(device, pipeline));
  REPRISE_TRY(commands.run([&](VkCommandBuffer buffer) -> Result<void> {
    changeLayout(device, buffer, {targets.color.image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_ASPECT_COLOR_BIT});
    changeLayout(device, buffer, {targets.depth.image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, VK_IMAGE_ASPECT_DEPTH_BIT});
    recordDraw(device, buffer, pipeline, targets);
    recordCopy(device, buffer, targets);
    return {};
  }));
  const Picture picture(targets.pixels.mapped);
  return LaneLoads{picture.helpersLoad(), picture.loads(kRejected), picture.loads(kDiscarded)};
}

std::string describeLanes(const LaneLoads& lanes) {
  std::string lacking;
  const auto add = [&](bool loads, const char* name) {
    if (!loads) lacking += (lacking.empty() ? "" : ", ") + std::string(name);
  };
  add(lanes.helper, "helper");
  add(lanes.rejected, "rejected");
  add(lanes.discarded, "discarded");
  return lacking.empty() ? "yes" : "no (" + lacking + ")";
}

Result<LaneLoads> probeLanes(const Context& context) {
  const FunctionSource functions = context.functions();
  return probeLanes(ProbedDevice{functions.instance, context.view().physical_device, functions.device, functions.get_instance_proc_addr,
                                 functions.get_device_proc_addr, context.queue(), context.queue_family()});
}

}  // namespace reprise
