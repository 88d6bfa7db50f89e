#include "profiler/session/scene_renderer.h"

#include <cstddef>
#include <cstring>
#include <map>

#include "profiler/scene/mesh.h"

namespace reprise {
namespace {

VkFormat formatOf(const std::string& name) {
  if (name == "rgba16_sfloat") return VK_FORMAT_R16G16B16A16_SFLOAT;
  if (name == "rgba32_sfloat") return VK_FORMAT_R32G32B32A32_SFLOAT;
  return VK_FORMAT_R8G8B8A8_UNORM;
}

VkFormat attributeFormat(int components) {
  constexpr VkFormat kFormats[] = {VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT, VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT};
  return kFormats[std::min(std::max(components, 1), 4) - 1];
}

// Where a vertex input lies: of which binding, how far in, and how many floats it has.
struct Attribute {
  std::uint32_t binding = 0;
  std::size_t offset = 0;
  int components = 4;
};

Attribute attributeOf(const std::string& name) {
  std::map<std::string, Attribute> attributes = {{"position", {0, offsetof(Vertex, position), 3}}, {"normal", {0, offsetof(Vertex, normal), 3}},
                                                 {"tangent", {0, offsetof(Vertex, tangent), 4}},   {"uv", {0, offsetof(Vertex, uv), 2}},
                                                 {"color", {0, offsetof(Vertex, color), 4}},       {"joints", {1, offsetof(DeformVertex, joints), 4}},
                                                 {"weights", {1, offsetof(DeformVertex, weights), 4}}};
  for (std::size_t target = 0; target < kMorphTargets; ++target) {
    const std::size_t offset = target * 3 * sizeof(float);
    attributes["morph_position_" + std::to_string(target)] = {1, offsetof(DeformVertex, morph_position) + offset, 3};
    attributes["morph_normal_" + std::to_string(target)] = {1, offsetof(DeformVertex, morph_normal) + offset, 3};
  }
  const auto found = attributes.find(name);
  REPRISE_CHECK(found != attributes.end(), name);
  return found->second;
}

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
  SceneObjects scene;
  std::vector<VkPushConstantRange> push_ranges;
  std::uint32_t push_bytes = 0;
  std::vector<std::vector<std::byte>> push_constants;  // by object
};

SceneRenderer::SceneRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer::~SceneRenderer() = default;

Result<SceneRenderer> SceneRenderer::create(const Context& context, Commands& commands, const Scenario& scenario,
                                            const ShaderInterface& interface) {
  auto state = std::make_unique<State>();
  state->context = &context;
  state->scenario = &scenario;
  state->interface = &interface;
  REPRISE_ASSIGN(state->scene, createSceneObjects(context, commands, scenario, interface));
  for (const PushConstantRange& range : interface.push_constants) {
    state->push_ranges.push_back({range.stages, range.offset, range.size_bytes});
    state->push_bytes = std::max(state->push_bytes, range.offset + range.size_bytes);
  }
  return SceneRenderer(std::move(state));
}

VkFormat SceneRenderer::colorFormat(std::size_t target) const {
  const std::vector<std::string>& formats = state_->scenario->state.color_formats;
  return target < formats.size() ? formatOf(formats[target]) : VK_FORMAT_R8G8B8A8_UNORM;
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
  RenderTargets targets;
  targets.extent = {state_->scenario->width, state_->scenario->height};
  ImageDescription description;
  description.extent = {targets.extent.width, targets.extent.height, 1};
  description.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  for (std::size_t i = 0; i < state_->interface->outputs.size(); ++i) {
    description.format = colorFormat(i);
    REPRISE_ASSIGN(Image image, createImage(device, description));
    targets.colors.push_back(std::move(image));
  }
  description.format = depthFormat();
  description.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  description.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
  if (state_->scenario->state.depth_stencil) description.aspect |= VK_IMAGE_ASPECT_STENCIL_BIT;
  REPRISE_ASSIGN(targets.depth, createImage(device, description));
  REPRISE_TRY(commands.run([&](VkCommandBuffer buffer) -> Result<void> {
    for (const Image& image : targets.colors)
      changeLayout(device, buffer, {image.image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_ASPECT_COLOR_BIT});
    changeLayout(device, buffer, {targets.depth.image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, description.aspect});
    return {};
  }));
  return targets;
}

Result<Player> SceneRenderer::createPlayer(const Package& package, const PlayerOptions& options) const {
  const State& state = *state_;
  const VkVertexInputBindingDescription bindings[] = {{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX}, {1, sizeof(DeformVertex), VK_VERTEX_INPUT_RATE_VERTEX}};
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (const VertexInput& input : state.interface->vertex_inputs) {
    const Attribute attribute = attributeOf(input.name);
    attributes.push_back({input.location, attribute.binding, attributeFormat(std::min(input.components, attribute.components)),
                          static_cast<std::uint32_t>(attribute.offset)});
  }
  VkPipelineVertexInputStateCreateInfo vertex_input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  vertex_input.vertexBindingDescriptionCount = readsDeformation(*state.interface) ? 2 : 1;
  vertex_input.pVertexBindingDescriptions = bindings;
  vertex_input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size());
  vertex_input.pVertexAttributeDescriptions = attributes.data();
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
  pipeline.push_constants = state.push_ranges;
  for (std::size_t i = 0; i < state.interface->outputs.size(); ++i) pipeline.color_formats.push_back(colorFormat(i));
  pipeline.depth_format = depthFormat();
  const FunctionSource functions = state.context->functions();
  return Player::create({functions.instance, state.context->view().physical_device, functions.device, functions.get_instance_proc_addr,
                         functions.get_device_proc_addr},
                        package, pipeline, options);
}

void SceneRenderer::setFrame(const SessionSpec& session, const FrameState& frame) {
  State& state = *state_;
  const std::size_t count = state.scene.objects.size();
  for (BlockSlots& block : state.scene.blocks)
    for (std::size_t object = 0; object < count; ++object) {
      const Descriptor& descriptor = *block.descriptor;
      const auto bytes = fillBlock(*state.scenario, session, frame, object, descriptor.name, descriptor.members, descriptor.size_bytes);
      std::memcpy(&block.buffer.mapped[block.stride * object], bytes.data(), bytes.size());
    }
  state.push_constants.resize(count);
  if (state.push_bytes > 0)
    for (std::size_t object = 0; object < count; ++object)
      state.push_constants[object] = fillBlock(*state.scenario, session, frame, object, state.interface->push_constant_name,
                                               state.interface->push_constant_members, state.push_bytes);
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
    draw.push_constants = state.push_constants[object];
    frame.draws.push_back(std::move(draw));
  }
  return player.record(commands, frame, [&](PassContext& pass) {
    for (std::size_t object = 0; object < state.scene.objects.size(); ++object) {
      const ObjectBuffers& buffers = state.scene.objects[object];
      const std::vector<VkDescriptorSet>& sets = state.scene.sets[object];
      if (!sets.empty())
        device.fn.vkCmdBindDescriptorSets(pass.commands(), VK_PIPELINE_BIND_POINT_GRAPHICS, pass.layout(), 0,
                                          static_cast<std::uint32_t>(sets.size()), sets.data(), 0, nullptr);
      for (const VkPushConstantRange& range : state.push_ranges)
        device.fn.vkCmdPushConstants(pass.commands(), pass.layout(), range.stageFlags, range.offset, range.size,
                                     state.push_constants[object].data() + range.offset);
      const VkBuffer vertices = buffers.vertices.buffer.get();
      const VkDeviceSize offset = 0;
      device.fn.vkCmdBindVertexBuffers(pass.commands(), 0, 1, &vertices, &offset);
      if (const VkBuffer deform = buffers.deform.buffer.get(); deform != VK_NULL_HANDLE)
        device.fn.vkCmdBindVertexBuffers(pass.commands(), 1, 1, &deform, &offset);
      device.fn.vkCmdBindIndexBuffer(pass.commands(), buffers.indices.buffer.get(), 0, VK_INDEX_TYPE_UINT32);
      pass.bindDraw(object + 1);
      device.fn.vkCmdDrawIndexed(pass.commands(), buffers.index_count, 1, 0, 0, 0);
    }
  });
}

}  // namespace reprise
