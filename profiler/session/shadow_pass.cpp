#include "profiler/session/shadow_pass.h"

#include <algorithm>

#include "profiler/session/scene_draws.h"
#include "profiler/session/vertex_layout.h"

namespace reprise {
namespace {

// A fragment shader's descriptors need no memory here.
ShaderInterface vertexPart(const ShaderInterface& whole) {
  ShaderInterface part = whole;
  part.outputs.clear();
  std::erase_if(part.descriptors, [](const Descriptor& descriptor) { return (descriptor.stages & kStageVertex) == 0; });
  return part;
}

Scenario withTexturesOf(const Scenario& whole, const ShaderInterface& interface) {
  Scenario scenario = whole;
  std::erase_if(scenario.textures, [&](const TextureSpec& texture) {
    return std::none_of(interface.descriptors.begin(), interface.descriptors.end(), [&](const Descriptor& descriptor) { return descriptor.name == texture.name; });
  });
  return scenario;
}

std::vector<std::size_t> castersOf(const Scenario& scenario, const PassSpec& pass) {
  std::vector<std::size_t> casters;
  for (std::size_t index = 0; index < scenario.objects.size(); ++index) {
    const Object& object = scenario.objects[index];
    const std::string& name = object.part ? scenario.models[object.part->model].name : object.name;
    if (pass.objects.empty() || std::find(pass.objects.begin(), pass.objects.end(), name) != pass.objects.end()) casters.push_back(index);
  }
  return casters;
}

class ShadowPass final : public ScenePass {
 public:
  ShadowPass(const PassParts& parts, const Package& original)
      : device_(parts.context->view()), interface_(vertexPart(original.interface)), scenario_(withTexturesOf(*parts.scenario, interface_)),
        textures_(parts.textures), pass_(parts.pass), casters_(castersOf(scenario_, spec())) {}

  Result<void> create(const PassParts& parts, const Package& original) {
    REPRISE_ASSIGN(scene_, createSceneObjects(*parts.context, *parts.commands, {&scenario_, &interface_, textures_}));
    REPRISE_TRY(createLayout());
    return createPipeline(original.modules.at(original.original.passes.front().vertex_module));
  }

  void setFrame(const SessionSpec& session, const FrameState& state) override {
    const FrameState seen = seenByPass(scenario_, state, pass_);
    fillScene({&scenario_, &session, &seen}, interface_, scene_);
  }

  Result<void> record(VkCommandBuffer commands) override {
    const RenderTargets& targets = textures_->targets[pass_];
    beginWriting(device_, commands, targets);
    VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    depth.imageView = targets.depth.view.get();
    depth.imageLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
    depth.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    depth.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    depth.clearValue.depthStencil = {1, 0};
    VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
    rendering.renderArea = {{0, 0}, targets.extent};
    rendering.layerCount = 1;
    rendering.pDepthAttachment = &depth;
    device_.fn.vkCmdBeginRendering(commands, &rendering);
    device_.fn.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    const VkViewport viewport = {0, 0, static_cast<float>(targets.extent.width), static_cast<float>(targets.extent.height), 0, 1};
    device_.fn.vkCmdSetViewport(commands, 0, 1, &viewport);
    device_.fn.vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
    for (const std::size_t object : casters_) {
      bindObject({&device_, commands, layout_.get()}, scene_, object);
      device_.fn.vkCmdDrawIndexed(commands, scene_.objects[object].index_count, 1, 0, 0, 0);
    }
    device_.fn.vkCmdEndRendering(commands);
    endWriting(device_, commands, targets);
    return {};
  }

 private:
  const PassSpec& spec() const { return scenario_.passes[pass_]; }

  Result<void> createLayout() {
    std::vector<VkDescriptorSetLayout> sets;
    for (const auto& set : scene_.set_layouts) sets.push_back(set.get());
    VkPipelineLayoutCreateInfo create{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    create.setLayoutCount = static_cast<std::uint32_t>(sets.size());
    create.pSetLayouts = sets.data();
    create.pushConstantRangeCount = static_cast<std::uint32_t>(scene_.push_ranges.size());
    create.pPushConstantRanges = scene_.push_ranges.data();
    VkPipelineLayout layout = VK_NULL_HANDLE;
    REPRISE_VK(device_.fn.vkCreatePipelineLayout(device_.device, &create, nullptr, &layout));
    layout_ = {device_.device, layout, device_.fn.vkDestroyPipelineLayout};
    return {};
  }

  Result<void> createPipeline(const std::vector<std::uint32_t>& vertex_words) {
    VkShaderModuleCreateInfo module_create{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    module_create.codeSize = vertex_words.size() * 4;
    module_create.pCode = vertex_words.data();
    VkShaderModule module = VK_NULL_HANDLE;
    REPRISE_VK(device_.fn.vkCreateShaderModule(device_.device, &module_create, nullptr, &module));
    const Handle<VkShaderModule> owned(device_.device, module, device_.fn.vkDestroyShaderModule);
    VkPipelineShaderStageCreateInfo stage{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    stage.stage = VK_SHADER_STAGE_VERTEX_BIT;
    stage.module = module;
    stage.pName = "main";
    const VertexLayout vertices(interface_);
    const VkPipelineVertexInputStateCreateInfo vertex_input = vertices.state();
    VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = viewport.scissorCount = 1;
    // Both sides cast shadows: planes and terrains have but one.
    VkPipelineRasterizationStateCreateInfo rasterization{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    rasterization.depthBiasEnable = VK_TRUE;
    rasterization.depthBiasSlopeFactor = spec().slope_bias;
    rasterization.lineWidth = 1;
    VkPipelineMultisampleStateCreateInfo multisample{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
    depth.depthCompareOp = VK_COMPARE_OP_LESS;
    const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO, nullptr, 0, 2, dynamic_states};
    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
    rendering.depthAttachmentFormat = textures_->targets[pass_].depth.format;
    VkGraphicsPipelineCreateInfo create{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    create.pNext = &rendering;
    create.stageCount = 1;
    create.pStages = &stage;
    create.pVertexInputState = &vertex_input;
    create.pInputAssemblyState = &assembly;
    create.pViewportState = &viewport;
    create.pRasterizationState = &rasterization;
    create.pMultisampleState = &multisample;
    create.pDepthStencilState = &depth;
    create.pDynamicState = &dynamic;
    create.layout = layout_.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    REPRISE_VK(device_.fn.vkCreateGraphicsPipelines(device_.device, VK_NULL_HANDLE, 1, &create, nullptr, &pipeline));
    pipeline_ = {device_.device, pipeline, device_.fn.vkDestroyPipeline};
    return {};
  }

  const DeviceView& device_;
  ShaderInterface interface_;
  Scenario scenario_;
  std::shared_ptr<const PassTextures> textures_;
  std::size_t pass_;
  std::vector<std::size_t> casters_;
  SceneObjects scene_;
  Handle<VkPipelineLayout> layout_;
  Handle<VkPipeline> pipeline_;
};

}  // namespace

Result<std::unique_ptr<ScenePass>> createShadowPass(const PassParts& parts, const Package& original) {
  auto pass = std::make_unique<ShadowPass>(parts, original);
  REPRISE_TRY(pass->create(parts, original));
  return std::unique_ptr<ScenePass>(std::move(pass));
}

}  // namespace reprise
