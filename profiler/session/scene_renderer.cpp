#include "profiler/session/scene_renderer.h"

#include <algorithm>

#include "profiler/scene/shared_inputs.h"
#include "profiler/session/gbuffer_pass.h"
#include "profiler/session/scene_draws.h"
#include "profiler/session/shadow_pass.h"
#include "profiler/session/vertex_layout.h"
#include "runtime/vulkan/lane_probe.h"

namespace reprise {
namespace {

VkCompareOp compareOp(DepthCompare compare) {
  switch (compare) {
    case DepthCompare::kLess: return VK_COMPARE_OP_LESS;
    case DepthCompare::kLessOrEqual: return VK_COMPARE_OP_LESS_OR_EQUAL;
    case DepthCompare::kGreater: return VK_COMPARE_OP_GREATER;
    case DepthCompare::kGreaterOrEqual: return VK_COMPARE_OP_GREATER_OR_EQUAL;
  }
  return VK_COMPARE_OP_LESS;
}

}  // namespace

struct SceneRenderer::State {
  const Context* context = nullptr;
  const Scenario* scenario = nullptr;
  const ShaderInterface* interface = nullptr;
  std::shared_ptr<const PassTextures> textures;
  SceneObjects scene;
  std::vector<std::unique_ptr<ScenePass>> passes;
};

SceneRenderer::SceneRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer::~SceneRenderer() = default;

Result<SceneRenderer> SceneRenderer::create(const Context& context, Commands& commands, const Scenario& scenario,
                                            const ShaderInterface& interface) {
  REPRISE_ASSIGN(PassTextures textures, createPassTextures(context, scenario));
  return create(context, commands, SceneSource{&scenario, &interface, std::make_shared<const PassTextures>(std::move(textures))});
}

Result<SceneRenderer> SceneRenderer::create(const Context& context, Commands& commands, const SceneSource& source) {
  auto state = std::make_unique<State>();
  state->context = &context;
  state->scenario = source.scenario;
  state->interface = source.interface;
  state->textures = source.textures;
  REPRISE_ASSIGN(state->scene, createSceneObjects(context, commands, source));
  return SceneRenderer(std::move(state));
}

Result<void> SceneRenderer::createPasses(Commands& commands, const Package& original, std::span<const Package> packages) {
  State& state = *state_;
  for (std::size_t pass = 0; pass < state.scenario->passes.size(); ++pass) {
    const PassParts parts = {state.context, &commands, state.scenario, state.textures, pass};
    const bool shadow = state.scenario->passes[pass].kind == ScenePassKind::kShadow;
    REPRISE_CHECK(shadow || pass < packages.size(), pass, packages.size());
    Result<std::unique_ptr<ScenePass>> made = shadow ? createShadowPass(parts, original) : createGBufferPass(parts, packages[pass]);
    if (!made.ok()) return made.error();
    state.passes.push_back(std::move(*made));
  }
  return {};
}

VkFormat SceneRenderer::colorFormat(std::size_t target) const {
  const std::vector<std::string>& formats = state_->scenario->state.color_formats;
  return target < formats.size() ? colorFormatOf(formats[target]) : VK_FORMAT_R8G8B8A8_UNORM;
}

VkFormat SceneRenderer::depthFormat() const {
  return state_->scenario->state.depth_stencil ? VK_FORMAT_D32_SFLOAT_S8_UINT : VK_FORMAT_D32_SFLOAT;
}

float SceneRenderer::clearDepth() const {
  const DepthCompare compare = state_->scenario->state.compare;
  return compare == DepthCompare::kGreater || compare == DepthCompare::kGreaterOrEqual ? 0.0f : 1.0f;
}

Result<RenderTargets> SceneRenderer::createTargets(Commands& commands) const {
  const DeviceView& device = state_->context->view();
  TargetFormats formats = {{state_->scenario->width, state_->scenario->height}, {}, depthFormat(), false};
  for (std::size_t i = 0; i < state_->interface->outputs.size(); ++i) formats.colors.push_back(colorFormat(i));
  REPRISE_ASSIGN(RenderTargets targets, createRenderTargets(device, formats));
  REPRISE_TRY(commands.run([&](VkCommandBuffer buffer) -> Result<void> {
    for (const Image& image : targets.colors)
      changeLayout(device, buffer, {image.image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_ASPECT_COLOR_BIT});
    changeLayout(device, buffer, {targets.depth.image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, depthAspect(formats.depth)});
    return {};
  }));
  return targets;
}

Result<Player> SceneRenderer::createPlayer(const Package& package, const PlayerOptions& options) const {
  const State& state = *state_;
  const VertexLayout vertices(*state.interface);
  const VkPipelineVertexInputStateCreateInfo vertex_input = vertices.state();
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineRasterizationStateCreateInfo rasterization{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  const CullMode cull = state.scenario->state.cull;
  rasterization.cullMode = cull == CullMode::kBack ? VK_CULL_MODE_BACK_BIT : cull == CullMode::kFront ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_NONE;
  rasterization.frontFace = kFrontFaceCounterClockwise ? VK_FRONT_FACE_COUNTER_CLOCKWISE : VK_FRONT_FACE_CLOCKWISE;
  rasterization.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo multisample{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = compareOp(state.scenario->state.compare);
  VkGraphicsPipelineCreateInfo create{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  create.pVertexInputState = &vertex_input;
  create.pInputAssemblyState = &assembly;
  create.pRasterizationState = &rasterization;
  create.pMultisampleState = &multisample;
  create.pDepthStencilState = &depth;
  ApplicationPipeline pipeline;
  pipeline.create_info = &create;
  for (const auto& layout : state.scene.set_layouts) pipeline.set_layouts.push_back(layout.get());
  pipeline.push_constants = state.scene.push_ranges;
  for (std::size_t i = 0; i < state.interface->outputs.size(); ++i) pipeline.color_formats.push_back(colorFormat(i));
  pipeline.depth_format = depthFormat();
  pipeline.draws_share_inputs = drawsShareInputs(*state.scenario, *state.interface);
  pipeline.conditional_rendering = state.context->has_conditional_rendering();
  if (package.variant.requirements.rejected_lanes_load) {
    REPRISE_ASSIGN(const LaneLoads lanes, probeLanes(*state.context));
    pipeline.rejected_lanes_load = lanes.rejected;
  }
  const FunctionSource functions = state.context->functions();
  return Player::create({functions.instance, state.context->view().physical_device, functions.device, functions.get_instance_proc_addr,
                         functions.get_device_proc_addr},
                        package, pipeline, options);
}

void SceneRenderer::setFrame(const SessionSpec& session, const FrameState& frame) {
  fillScene({state_->scenario, &session, &frame}, *state_->interface, state_->scene);
  for (const std::unique_ptr<ScenePass>& pass : state_->passes) pass->setFrame(session, frame);
}

bool SceneRenderer::hasPasses() const { return !state_->passes.empty(); }

Result<void> SceneRenderer::recordPasses(VkCommandBuffer commands) const {
  for (const std::unique_ptr<ScenePass>& pass : state_->passes) REPRISE_TRY(pass->record(commands));
  return {};
}

Result<void> SceneRenderer::record(VkCommandBuffer commands, Player& player, const RenderTargets& targets, std::uint32_t period_frames,
                                   const FrameQueries& queries) const {
  const State& state = *state_;
  const DeviceView& device = state.context->view();
  FrameInputs frame;
  frame.extent = targets.extent;
  frame.viewport = {0, 0, static_cast<float>(targets.extent.width), static_cast<float>(targets.extent.height), 0, 1};
  for (const Image& image : targets.colors) {
    ColorTarget target;
    target.view = image.view.get();
    std::copy(state.scenario->state.clear.begin(), state.scenario->state.clear.end(), target.clear.float32);
    frame.colors.push_back(target);
  }
  frame.depth.view = targets.depth.view.get();
  frame.depth.clear_depth = clearDepth();
  frame.period_frames = period_frames;
  frame.timestamps = queries.timestamps;
  for (std::size_t object = 0; object < state.scene.objects.size(); ++object) {
    DrawInputs draw;
    draw.id = object + 1;
    for (const BlockSlots& block : state.scene.blocks)
      draw.blocks.push_back({block.descriptor->set, block.descriptor->binding,
                             std::span<const std::byte>(block.buffer.mapped).subspan(block.stride * object, block.stride)});
    draw.push_constants = state.scene.push_constants[object];
    frame.draws.push_back(std::move(draw));
  }
  return player.record(commands, frame, [&](PassContext& pass) {
    for (std::size_t object = 0; object < state.scene.objects.size(); ++object) {
      bindObject({&device, pass.commands(), pass.layout()}, state.scene, object);
      pass.bindDraw(object + 1);
      device.fn.vkCmdDrawIndexed(pass.commands(), state.scene.objects[object].index_count, 1, 0, 0, 0);
    }
  });
}

}  // namespace reprise
