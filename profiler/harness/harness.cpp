#include "profiler/harness/harness.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/glm.hpp>

#include "profiler/harness/made_up_descriptors.h"
#include "profiler/scene/mesh.h"
#include "runtime/vulkan/lane_probe.h"
#include "runtime/vulkan/readback.h"

namespace reprise {
namespace {

constexpr const char* kSceneBlock = "HarnessScene";
constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT_S8_UINT;
constexpr std::size_t kGivenIntegers = 128;  // of varyings: location x 4 + component
constexpr VkDeviceSize kSlotBytes = 1024;

// The block of compiler/source/harness_vertex.h.
struct SceneBlock {
  glm::mat4 view_projection, model;
  glm::uvec3 seed;
  std::uint32_t padding = 0;
  std::array<std::uint32_t, kGivenIntegers> given;
};
static_assert(sizeof(SceneBlock) <= kSlotBytes);

std::vector<MeshSpec> meshes() {
  MeshSpec ball, knot, floor;
  ball.segments_u = 24, ball.segments_v = 12, ball.radius = 0.8f;
  knot.kind = MeshKind::kTorusKnot, knot.segments_u = 48, knot.segments_v = 6, knot.radius = 0.7f, knot.tube_radius = 0.25f;
  floor.kind = MeshKind::kPlane, floor.segments_u = floor.segments_v = 4, floor.size = 5;
  return {ball, knot, floor};
}

// The ball passes before the knot, the knot turns, the floor stands; the camera goes round.
SceneBlock sceneAt(int frame, std::size_t object, const HarnessOptions& options) {
  const std::uint32_t seed = options.seed;
  const float time = static_cast<float>(frame);
  SceneBlock block;
  const float angle = 0.3f * static_cast<float>(seed) + 0.015f * time;
  const glm::vec3 eye(3.2f * std::sin(angle), 1.3f, 3.2f * std::cos(angle));
  glm::mat4 projection = glm::perspectiveRH_ZO(0.9f, 1.0f, 0.3f, 20.0f);
  projection[1][1] = -projection[1][1];
  block.view_projection = projection * glm::lookAtRH(eye, glm::vec3(0), glm::vec3(0, 1, 0));
  block.model = glm::mat4(1);
  if (object == 0) block.model = glm::translate(block.model, glm::vec3(-0.8f + 0.05f * time, 0.2f, 0.9f));
  if (object == 1) block.model = glm::rotate(glm::translate(block.model, glm::vec3(0.3f, 0.2f, -0.2f)), 0.02f * time, glm::vec3(0, 1, 0));
  if (object == 2) block.model = glm::translate(block.model, glm::vec3(0, -0.9f, 0));
  block.seed = glm::uvec3(seed * 0x9e3779b9u + 1, seed, (seed - 1) % 4);
  block.given.fill(MadeUpValues::kAnyInteger);
  for (const IntegerValue& one : options.integers) {
    const std::size_t at = one.input.location * 4 + one.input.component;
    if (one.input.kind == IntegerInput::Kind::kVarying && at < kGivenIntegers) block.given[at] = one.value;
  }
  return block;
}

VkFormat formatOf(ScalarKind scalar) {
  if (scalar == ScalarKind::kInt) return VK_FORMAT_R32G32B32A32_SINT;
  return scalar == ScalarKind::kUint ? VK_FORMAT_R32G32B32A32_UINT : VK_FORMAT_R32G32B32A32_SFLOAT;
}

struct DrawnMesh {
  Buffer vertices, indices;
  std::uint32_t index_count = 0;
};

Result<DrawnMesh> upload(const DeviceView& device, const MeshSpec& spec) {
  const Mesh mesh = buildMesh(spec);
  DrawnMesh drawn;
  REPRISE_ASSIGN(drawn.vertices, createBuffer(device, mesh.vertices.size() * sizeof(Vertex), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT));
  REPRISE_ASSIGN(drawn.indices, createBuffer(device, mesh.indices.size() * 4, VK_BUFFER_USAGE_INDEX_BUFFER_BIT));
  std::memcpy(drawn.vertices.mapped.data(), mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
  std::memcpy(drawn.indices.mapped.data(), mesh.indices.data(), mesh.indices.size() * 4);
  drawn.index_count = static_cast<std::uint32_t>(mesh.indices.size());
  return drawn;
}

}  // namespace

struct Harness::State {
  const Context* context = nullptr;
  Commands* commands = nullptr;
  const ShaderInterface* interface = nullptr;
  const Descriptor* scene = nullptr;
  HarnessOptions options;
  MadeUpDescriptors descriptors;
  Buffer scene_blocks;
  std::vector<VkPushConstantRange> push_ranges;
  std::vector<std::byte> first_push_constants, push_constants;
  std::vector<DrawnMesh> meshes;
  std::vector<Image> colors;
  Image depth;
  std::unique_ptr<Readback> readback;

  Result<void> createTargets();
  void writeInputs(int frame);
  FrameInputs frameInputs(std::uint32_t period_frames) const;
  void draw(PassContext& pass) const;
  Result<std::vector<std::uint32_t>> words(const ReadbackSource& source);
};

Harness::Harness(std::unique_ptr<State> state) : state_(std::move(state)) {}
Harness::Harness(Harness&&) noexcept = default;
Harness::~Harness() = default;

Result<Harness> Harness::create(const Context& context, Commands& commands, const ShaderInterface& interface, const HarnessOptions& options) {
  auto state = std::make_unique<State>();
  state->context = &context;
  state->commands = &commands;
  state->interface = &interface;
  state->options = options;
  const auto scene = std::find_if(interface.descriptors.begin(), interface.descriptors.end(),
                                  [](const Descriptor& descriptor) { return descriptor.name == kSceneBlock; });
  REPRISE_CHECK(scene != interface.descriptors.end(), interface.descriptors.size());
  state->scene = &*scene;
  MadeUpValues values(options.seed, integerLimit(interface));
  REPRISE_ASSIGN(state->descriptors, makeUpDescriptors(context, commands, interface, state->scene, options.integers, values));
  for (const MeshSpec& spec : meshes()) {
    REPRISE_ASSIGN(DrawnMesh drawn, upload(context.view(), spec));
    state->meshes.push_back(std::move(drawn));
  }
  REPRISE_ASSIGN(state->scene_blocks, createBuffer(context.view(), kSlotBytes * state->meshes.size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT));
  VkDescriptorBufferInfo info{state->scene_blocks.buffer.get(), 0, sizeof(SceneBlock)};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = state->descriptors.sets[scene->set];
  write.dstBinding = scene->binding;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
  write.pBufferInfo = &info;
  context.view().fn.vkUpdateDescriptorSets(context.view().device, 1, &write, 0, nullptr);
  std::size_t push_bytes = 0;
  for (const PushConstantRange& range : interface.push_constants) {
    state->push_ranges.push_back({range.stages, range.offset, range.size_bytes});
    push_bytes = std::max<std::size_t>(push_bytes, range.offset + range.size_bytes);
  }
  state->first_push_constants = madeUpBlock(interface.push_constant_members, push_bytes, values);
  putPushedIntegers(options.integers, integerLimit(interface), state->first_push_constants);
  state->readback = std::make_unique<Readback>(context);
  REPRISE_TRY(state->createTargets());
  return Harness(std::move(state));
}

Result<void> Harness::State::createTargets() {
  const DeviceView& device = context->view();
  ImageDescription description;
  description.extent = {options.width, options.height, 1};
  description.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  for (const FragmentOutput& output : interface->outputs) {
    description.format = formatOf(output.scalar);
    REPRISE_ASSIGN(Image image, createImage(device, description));
    colors.push_back(std::move(image));
  }
  description.format = kDepthFormat;
  description.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  description.aspect = VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
  REPRISE_ASSIGN(depth, createImage(device, description));
  return commands->run([&](VkCommandBuffer buffer) -> Result<void> {
    for (const Image& image : colors)
      changeLayout(device, buffer, {image.image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_ASPECT_COLOR_BIT});
    changeLayout(device, buffer, {depth.image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, description.aspect});
    return {};
  });
}

Result<Player> Harness::createPlayer(const Package& package, bool original) const {
  const State& state = *state_;
  const VkVertexInputBindingDescription binding{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (const VertexInput& input : state.interface->vertex_inputs) {
    const bool is_uv = input.name == "uv";
    const std::size_t offset = is_uv ? offsetof(Vertex, uv) : input.name == "normal" ? offsetof(Vertex, normal) : offsetof(Vertex, position);
    attributes.push_back({input.location, 0, is_uv ? VK_FORMAT_R32G32_SFLOAT : VK_FORMAT_R32G32B32_SFLOAT, static_cast<std::uint32_t>(offset)});
  }
  VkPipelineVertexInputStateCreateInfo vertex_input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  vertex_input.vertexBindingDescriptionCount = 1;
  vertex_input.pVertexBindingDescriptions = &binding;
  vertex_input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size());
  vertex_input.pVertexAttributeDescriptions = attributes.data();
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineRasterizationStateCreateInfo rasterization{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  rasterization.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo multisample{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = VK_COMPARE_OP_LESS;
  // Channels that the shader has no components for are undefined; unwritten they are zero.
  std::vector<VkPipelineColorBlendAttachmentState> attachments;
  for (const FragmentOutput& output : state.interface->outputs) {
    attachments.emplace_back();
    attachments.back().colorWriteMask = output.components < 4 ? (1u << output.components) - 1 : 0xfu;
  }
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = static_cast<std::uint32_t>(attachments.size());
  blend.pAttachments = attachments.data();
  VkGraphicsPipelineCreateInfo create{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  create.pColorBlendState = &blend;
  create.pVertexInputState = &vertex_input;
  create.pInputAssemblyState = &assembly;
  create.pRasterizationState = &rasterization;
  create.pMultisampleState = &multisample;
  create.pDepthStencilState = &depth;
  ApplicationPipeline pipeline;
  pipeline.create_info = &create;
  for (const auto& layout : state.descriptors.layouts) pipeline.set_layouts.push_back(layout.get());
  pipeline.push_constants = state.push_ranges;
  for (const FragmentOutput& output : state.interface->outputs) pipeline.color_formats.push_back(formatOf(output.scalar));
  pipeline.depth_format = kDepthFormat;
  pipeline.conditional_rendering = state.context->has_conditional_rendering();
  pipeline.draws_share_inputs = true;  // all meshes are drawn with one set of made-up inputs
  if (package.variant.requirements.rejected_lanes_load) {
    REPRISE_ASSIGN(const LaneLoads lanes, probeLanes(*state.context));
    pipeline.rejected_lanes_load = lanes.rejected;
  }
  const FunctionSource functions = state.context->functions();
  PlayerOptions options;
  options.frames_in_flight = 1;
  options.force_original = original;
  return Player::create({functions.instance, state.context->view().physical_device, functions.device, functions.get_instance_proc_addr,
                         functions.get_device_proc_addr},
                        package, pipeline, options);
}

void Harness::State::writeInputs(int frame) {
  for (std::size_t object = 0; object < meshes.size(); ++object) {
    const SceneBlock block = sceneAt(frame, object, options);
    std::memcpy(&scene_blocks.mapped[kSlotBytes * object], &block, sizeof block);
  }
  moveBlocks(descriptors, frame);
  push_constants = blockAtFrame(interface->push_constant_members, first_push_constants, frame);
}

FrameInputs Harness::State::frameInputs(std::uint32_t period_frames) const {
  FrameInputs inputs;
  inputs.extent = {options.width, options.height};
  inputs.viewport = {0, 0, static_cast<float>(options.width), static_cast<float>(options.height), 0, 1};
  for (const Image& image : colors) {
    ColorTarget target;
    target.view = image.view.get();
    inputs.colors.push_back(target);
  }
  inputs.depth.view = depth.view.get();
  inputs.period_frames = period_frames;
  for (std::size_t object = 0; object < meshes.size(); ++object) {
    DrawInputs draw;
    draw.id = object + 1;
    draw.blocks.push_back({scene->set, scene->binding, std::span<const std::byte>(scene_blocks.mapped).subspan(kSlotBytes * object, kSlotBytes)});
    draw.push_constants = push_constants;
    inputs.draws.push_back(std::move(draw));
  }
  return inputs;
}

void Harness::State::draw(PassContext& pass) const {
  const DeviceView& device = context->view();
  for (std::size_t object = 0; object < meshes.size(); ++object) {
    const std::uint32_t slot = static_cast<std::uint32_t>(kSlotBytes * object);
    device.fn.vkCmdBindDescriptorSets(pass.commands(), VK_PIPELINE_BIND_POINT_GRAPHICS, pass.layout(), 0,
                                      static_cast<std::uint32_t>(descriptors.sets.size()), descriptors.sets.data(), 1, &slot);
    for (const VkPushConstantRange& range : push_ranges)
      device.fn.vkCmdPushConstants(pass.commands(), pass.layout(), range.stageFlags, range.offset, range.size, &push_constants[range.offset]);
    const VkBuffer vertices = meshes[object].vertices.buffer.get();
    const VkDeviceSize offset = 0;
    device.fn.vkCmdBindVertexBuffers(pass.commands(), 0, 1, &vertices, &offset);
    device.fn.vkCmdBindIndexBuffer(pass.commands(), meshes[object].indices.buffer.get(), 0, VK_INDEX_TYPE_UINT32);
    pass.bindDraw(object + 1);
    device.fn.vkCmdDrawIndexed(pass.commands(), meshes[object].index_count, 1, 0, 0, 0);
  }
}

Result<std::vector<std::uint32_t>> Harness::State::words(const ReadbackSource& source) {
  REPRISE_ASSIGN(const auto bytes, readback->read(*commands, source));
  std::vector<std::uint32_t> result(bytes.size() / 4);
  std::memcpy(result.data(), bytes.data(), result.size() * 4);
  return result;
}

Result<HarnessFrame> Harness::play(Player& player, const Shot& shot) {
  State& state = *state_;
  state.writeInputs(shot.frame);
  const FrameInputs inputs = state.frameInputs(shot.period_frames);
  REPRISE_TRY(state.commands->run(
      [&](VkCommandBuffer buffer) { return player.record(buffer, inputs, [&](PassContext& pass) { state.draw(pass); }); }));
  HarnessFrame frame;
  for (const Image& image : state.colors) {
    REPRISE_ASSIGN(std::vector<std::uint32_t> color, state.words({image.image.get(), image.format, inputs.extent, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}));
    frame.colors.push_back(std::move(color));
  }
  // D32_SFLOAT names the depth of images with stencil, too.
  REPRISE_ASSIGN(frame.depth, state.words({state.depth.image.get(), VK_FORMAT_D32_SFLOAT, inputs.extent, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL}));
  if (const auto kind = player.resource("kind")) {
    REPRISE_ASSIGN(const auto bytes, state.readback->read(*state.commands, {kind->image, kind->format, kind->extent, kind->layout}));
    frame.kind.resize(bytes.size());
    std::memcpy(frame.kind.data(), bytes.data(), bytes.size());
  }
  return frame;
}

}  // namespace reprise
