#include "runtime/playback/pass_pipelines.h"

#include <algorithm>
#include <map>

#include "runtime/playback/formats.h"

namespace reprise {
namespace {

const Resource& resourceOf(const Recipe& recipe, const std::string& name) {
  const auto found = std::find_if(recipe.resources.begin(), recipe.resources.end(), [&](const Resource& one) { return one.name == name; });
  REPRISE_CHECK(found != recipe.resources.end(), name);
  return *found;
}

constexpr VkShaderStageFlags kBothStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

std::vector<VkDescriptorSetLayoutBinding> ownBindings(const Recipe& recipe) {
  std::map<std::uint32_t, VkDescriptorSetLayoutBinding> bindings;
  const auto add = [&](std::uint32_t binding, VkDescriptorType type) { bindings[binding] = {binding, type, 1, kBothStages, nullptr}; };
  add(0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
  add(1, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC);
  for (const Pass& pass : recipe.passes)
    for (const Read& read : pass.reads) add(read.binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
  for (const PreviousInput& input : recipe.previous_inputs)
    if (input.source == PreviousSource::kUniformBlock) add(input.reprise_binding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC);
  if (recipe.flags != MissFlagging::kNone) add(kFlagsBinding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
  std::vector<VkDescriptorSetLayoutBinding> list;
  for (const auto& [number, binding] : bindings) list.push_back(binding);
  return list;
}

Result<Handle<VkDescriptorSetLayout>> createSetLayout(const DeviceView& device,
                                                      const std::vector<VkDescriptorSetLayoutBinding>& bindings) {
  VkDescriptorSetLayoutCreateInfo create{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  create.bindingCount = static_cast<std::uint32_t>(bindings.size());
  create.pBindings = bindings.data();
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateDescriptorSetLayout(device.device, &create, nullptr, &layout));
  return Handle<VkDescriptorSetLayout>(device.device, layout, device.fn.vkDestroyDescriptorSetLayout);
}

Result<void> createLayouts(const DeviceView& device, const Recipe& recipe, const ApplicationPipeline& application,
                           PassPipelines& result) {
  std::vector<VkDescriptorSetLayout> sets = application.set_layouts;
  if (recipe.uses_reprise_set) {
    REPRISE_CHECK(sets.size() <= recipe.reprise_set, sets.size(), recipe.reprise_set);
    while (sets.size() < recipe.reprise_set) {
      REPRISE_ASSIGN(Handle<VkDescriptorSetLayout> empty, createSetLayout(device, {}));
      sets.push_back(empty.get());
      result.own_layouts.push_back(std::move(empty));
    }
    REPRISE_ASSIGN(Handle<VkDescriptorSetLayout> own, createSetLayout(device, ownBindings(recipe)));
    sets.push_back(own.get());
    result.own_layouts.push_back(std::move(own));
  }
  VkPipelineLayoutCreateInfo create{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  create.setLayoutCount = static_cast<std::uint32_t>(sets.size());
  create.pSetLayouts = sets.data();
  create.pushConstantRangeCount = static_cast<std::uint32_t>(application.push_constants.size());
  create.pPushConstantRanges = application.push_constants.data();
  VkPipelineLayout layout = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreatePipelineLayout(device.device, &create, nullptr, &layout));
  result.layout = {device.device, layout, device.fn.vkDestroyPipelineLayout};
  return {};
}

VkPipelineDepthStencilStateCreateInfo depthState(const ApplicationPipeline& application, const Pass& pass) {
  VkPipelineDepthStencilStateCreateInfo state{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  if (application.depth_format == VK_FORMAT_UNDEFINED) return state;
  if (application.create_info->pDepthStencilState != nullptr) state = *application.create_info->pDepthStencilState;
  state.pNext = nullptr;
  if (pass.depth == DepthUse::kNone) state.depthTestEnable = state.depthWriteEnable = state.stencilTestEnable = state.depthBoundsTestEnable = VK_FALSE;
  if (pass.depth == DepthUse::kEqualNoWrite) {
    state.depthCompareOp = VK_COMPARE_OP_EQUAL;
    state.depthWriteEnable = VK_FALSE;
  }
  if (pass.stencil == StencilUse::kMarkIfZero) {
    // Replace would write the reference, which has to be 0 for the comparison.
    VkStencilOpState mark{VK_STENCIL_OP_KEEP, VK_STENCIL_OP_INCREMENT_AND_CLAMP, VK_STENCIL_OP_KEEP, VK_COMPARE_OP_EQUAL, 0xff, 0xff, 0};
    state.stencilTestEnable = VK_TRUE;
    state.front = state.back = mark;
  }
  return state;
}

std::vector<VkPipelineColorBlendAttachmentState> blendStates(const Pass& pass, const ApplicationPipeline& application, std::size_t count) {
  constexpr VkColorComponentFlags kAll =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  std::vector<VkPipelineColorBlendAttachmentState> states(count);
  const VkPipelineColorBlendStateCreateInfo* given = application.create_info->pColorBlendState;
  for (const ColorAttachment& color : pass.colors) {
    VkPipelineColorBlendAttachmentState& state = states[static_cast<std::size_t>(color.location)];
    state.colorWriteMask = kAll;
    if (color.resource.empty() && given != nullptr && static_cast<std::uint32_t>(color.app_target) < given->attachmentCount)
      state = given->pAttachments[color.app_target];
    if (color.blend == BlendKind::kAdd) {
      state.blendEnable = VK_TRUE;
      state.srcColorBlendFactor = state.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
      state.srcAlphaBlendFactor = state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
      state.colorBlendOp = state.alphaBlendOp = VK_BLEND_OP_ADD;
    }
  }
  return states;
}

Result<Handle<VkShaderModule>> createModule(const DeviceView& device, const std::vector<std::uint32_t>& words) {
  VkShaderModuleCreateInfo create{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  create.codeSize = words.size() * 4;
  create.pCode = words.data();
  VkShaderModule module = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateShaderModule(device.device, &create, nullptr, &module));
  return Handle<VkShaderModule>(device.device, module, device.fn.vkDestroyShaderModule);
}

VkPipelineShaderStageCreateInfo stageInfo(VkShaderStageFlagBits stage, VkShaderModule module) {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = stage;
  info.module = module;
  info.pName = "main";
  return info;
}

// The player's own geometry, whose vertices come from nothing but their numbers.
struct TileGeometry {
  VkPipelineVertexInputStateCreateInfo vertex_input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  VkPipelineRasterizationStateCreateInfo rasterization{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};

  TileGeometry() {
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
    rasterization.cullMode = VK_CULL_MODE_NONE;
    rasterization.lineWidth = 1;
  }

  void applyTo(VkGraphicsPipelineCreateInfo& create) const {
    create.pVertexInputState = &vertex_input;
    create.pInputAssemblyState = &assembly;
    create.pRasterizationState = &rasterization;
    create.pTessellationState = nullptr;
  }
};

Result<Handle<VkPipeline>> createPipeline(const DeviceView& device, const Package& package, const Recipe& recipe,
                                          const ApplicationPipeline& application, const Pass& pass, VkPipelineLayout layout) {
  REPRISE_ASSIGN(const Handle<VkShaderModule> vertex, createModule(device, package.modules.at(pass.vertex_module)));
  std::vector<VkPipelineShaderStageCreateInfo> stages{stageInfo(VK_SHADER_STAGE_VERTEX_BIT, vertex.get())};
  Handle<VkShaderModule> fragment;
  if (!pass.fragment_module.empty()) {
    REPRISE_ASSIGN(fragment, createModule(device, package.modules.at(pass.fragment_module)));
    stages.push_back(stageInfo(VK_SHADER_STAGE_FRAGMENT_BIT, fragment.get()));
  }
  const std::vector<VkFormat> formats = attachmentFormats(recipe, pass, application);
  const auto blends = blendStates(pass, application, formats.size());
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = static_cast<std::uint32_t>(formats.size());
  rendering.pColorAttachmentFormats = formats.data();
  rendering.depthAttachmentFormat = application.depth_format;
  rendering.stencilAttachmentFormat = hasStencil(application.depth_format) ? application.depth_format : VK_FORMAT_UNDEFINED;
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = static_cast<std::uint32_t>(blends.size());
  blend.pAttachments = blends.data();
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = 2;
  dynamic.pDynamicStates = dynamic_states;
  const VkPipelineDepthStencilStateCreateInfo depth = depthState(application, pass);
  const TileGeometry tiles;
  VkGraphicsPipelineCreateInfo create = *application.create_info;
  if (pass.kind == PassKind::kTiles) tiles.applyTo(create);
  create.pNext = &rendering;
  create.stageCount = static_cast<std::uint32_t>(stages.size());
  create.pStages = stages.data();
  create.pViewportState = &viewport;
  create.pDepthStencilState = &depth;
  create.pColorBlendState = &blend;
  create.pDynamicState = &dynamic;
  create.layout = layout;
  create.renderPass = VK_NULL_HANDLE;
  create.subpass = 0;
  create.basePipelineHandle = VK_NULL_HANDLE;
  create.basePipelineIndex = -1;
  create.flags = 0;
  VkPipeline pipeline = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateGraphicsPipelines(device.device, VK_NULL_HANDLE, 1, &create, nullptr, &pipeline));
  return Handle<VkPipeline>(device.device, pipeline, device.fn.vkDestroyPipeline);
}

}  // namespace

std::vector<VkFormat> attachmentFormats(const Recipe& recipe, const Pass& pass, const ApplicationPipeline& application) {
  std::vector<VkFormat> formats;
  for (const ColorAttachment& color : pass.colors) {
    const auto location = static_cast<std::size_t>(color.location);
    if (formats.size() <= location) formats.resize(location + 1, VK_FORMAT_UNDEFINED);
    formats[location] = color.resource.empty() ? application.color_formats.at(static_cast<std::size_t>(color.app_target))
                                               : vulkanFormat(resourceOf(recipe, color.resource).format);
  }
  return formats;
}

Result<PassPipelines> createPipelines(const DeviceView& device, const Package& package, const Recipe& recipe,
                                      const ApplicationPipeline& application) {
  PassPipelines result;
  REPRISE_TRY(createLayouts(device, recipe, application, result));
  for (const Pass& pass : recipe.passes) {
    REPRISE_ASSIGN(Handle<VkPipeline> pipeline, createPipeline(device, package, recipe, application, pass, result.layout.get()));
    result.pipelines.push_back(std::move(pipeline));
  }
  return result;
}

}  // namespace reprise
