#include "renderer.h"

#include <cstring>
#include <span>
#include <stdexcept>
#include <utility>

#include "pipeline_state.h"

namespace embed {

namespace {

constexpr VkPushConstantRange kObjectRange = {VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(ObjectConstants)};

template <typename T>
Buffer createFilledBuffer(VulkanApp& app, const std::vector<T>& values, VkBufferUsageFlags usage) {
  const std::size_t size_bytes = values.size() * sizeof(T);
  const Buffer buffer = app.createBuffer(size_bytes, usage);
  std::memcpy(buffer.mapped, values.data(), size_bytes);
  return buffer;
}

template <typename T>
T valueOrThrow(reprise::Result<T> result) {
  if (!result.ok()) throw std::runtime_error(reprise::formatError(result.error()));
  return std::move(result).value();
}

}  // namespace

Renderer::Renderer(VulkanApp& app, const reprise::Package& package, Mode mode)
    : app_(app), targets_(app, {kWidth, kHeight}) {
  for (const Object& object : sceneObjects()) {
    const Mesh mesh = makeSquare(object.edge_length);
    object_buffers_.push_back({createFilledBuffer(app, mesh.vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT),
                               createFilledBuffer(app, mesh.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT),
                               static_cast<std::uint32_t>(mesh.indices.size())});
  }
  frame_buffer_ = app.createBuffer(sizeof(FrameBlock), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  createDescriptorSet();
  createPlayer(package, mode);
}

Renderer::~Renderer() {
  vkDeviceWaitIdle(app_.device());  // the player may go only after the frames in flight
  player_.reset();
  vkDestroyDescriptorPool(app_.device(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(app_.device(), set_layout_, nullptr);
}

void Renderer::createDescriptorSet() {
  VkDescriptorSetLayoutBinding binding{};
  binding.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  binding.descriptorCount = 1;
  binding.stageFlags = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
  VkDescriptorSetLayoutCreateInfo layout_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  layout_info.bindingCount = 1;
  layout_info.pBindings = &binding;
  check(vkCreateDescriptorSetLayout(app_.device(), &layout_info, nullptr, &set_layout_),
        "no descriptor set layout");

  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1};
  VkDescriptorPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool_info.maxSets = 1;
  pool_info.poolSizeCount = 1;
  pool_info.pPoolSizes = &size;
  check(vkCreateDescriptorPool(app_.device(), &pool_info, nullptr, &pool_), "no descriptor pool");

  VkDescriptorSetAllocateInfo set_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  set_info.descriptorPool = pool_;
  set_info.descriptorSetCount = 1;
  set_info.pSetLayouts = &set_layout_;
  check(vkAllocateDescriptorSets(app_.device(), &set_info, &set_), "no descriptor set");

  const VkDescriptorBufferInfo buffer{frame_buffer_.handle, 0, sizeof(FrameBlock)};
  VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set_;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  write.pBufferInfo = &buffer;
  vkUpdateDescriptorSets(app_.device(), 1, &write, 0, nullptr);
}

void Renderer::createPlayer(const reprise::Package& package, Mode mode) {
  reprise::DeviceHandles device;
  device.instance = app_.instance();
  device.physical_device = app_.physicalDevice();
  device.device = app_.device();
  device.get_instance_proc_addr = vkGetInstanceProcAddr;
  device.get_device_proc_addr = vkGetDeviceProcAddr;

  // The player reads the state while it is created and keeps nothing of it.
  const PipelineState state;
  reprise::ApplicationPipeline pipeline;
  pipeline.create_info = &state.create_info;
  pipeline.set_layouts = {set_layout_};
  pipeline.push_constants = {kObjectRange};
  pipeline.color_formats = {Targets::kColorFormat};
  pipeline.depth_format = Targets::kDepthFormat;

  reprise::PlayerOptions options;
  options.frames_in_flight = 1;  // submitAndWait() lets no frame overlap another
  options.force_original = mode == Mode::kOriginal;
  player_ = valueOrThrow(reprise::Player::create(device, package, pipeline, options));
}

std::vector<std::uint8_t> Renderer::renderFrame(int frame) {
  object_constants_.clear();
  for (const Object& object : sceneObjects()) object_constants_.push_back(objectConstants(object, frame));
  frame_block_ = frameBlock(frame);
  std::memcpy(frame_buffer_.mapped, &frame_block_, sizeof(frame_block_));

  const VkCommandBuffer commands = app_.begin();
  targets_.recordBegin(commands);
  record(commands);
  targets_.recordReadBack(commands);
  app_.submitAndWait();
  return targets_.pixels();
}

void Renderer::record(VkCommandBuffer commands) {
  reprise::FrameInputs inputs;
  inputs.extent = targets_.extent();
  inputs.viewport = {0, 0, static_cast<float>(kWidth), static_cast<float>(kHeight), 0, 1};
  inputs.colors = {{.view = targets_.colorView(), .clear = {.float32 = {0, 0, 0, 1}}}};
  inputs.depth = {.view = targets_.depthView(), .clear_depth = 1};
  inputs.period_frames =
      player_->recipe().period_frames;  // the one that Reprise chose; it may change from frame to frame

  // To find where a point was in the last frame, the cached variant needs what its position was computed
  // from. The player keeps last frame's bytes; all it wants from the application is this frame's.
  const auto block_bytes = std::as_bytes(std::span(&frame_block_, 1));
  for (std::size_t i = 0; i < sceneObjects().size(); ++i) {
    reprise::DrawInputs draw;
    draw.id = sceneObjects()[i].id;
    draw.blocks = {{.set = 0, .binding = 0, .bytes = block_bytes}};
    draw.push_constants = std::as_bytes(std::span(&object_constants_[i], 1));
    inputs.draws.push_back(draw);
  }
  const reprise::Result<void> recorded =
      player_->record(commands, inputs, [&](reprise::PassContext& pass) { drawObjects(pass); });
  if (!recorded.ok()) throw std::runtime_error(reprise::formatError(recorded.error()));
}

// Called once for each pass of the variant that is played, with the pass's pipeline bound. Binds and draws as
// ever; bindDraw tells Reprise whose turn it is.
void Renderer::drawObjects(reprise::PassContext& pass) const {
  const VkCommandBuffer commands = pass.commands();
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass.layout(), 0, 1, &set_, 0, nullptr);
  for (std::size_t i = 0; i < sceneObjects().size(); ++i) {
    pass.bindDraw(sceneObjects()[i].id);
    vkCmdPushConstants(commands, pass.layout(), kObjectRange.stageFlags, 0, sizeof(ObjectConstants),
                       &object_constants_[i]);
    const VkDeviceSize offset = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &object_buffers_[i].vertices.handle, &offset);
    vkCmdBindIndexBuffer(commands, object_buffers_[i].indices.handle, 0, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands, object_buffers_[i].index_count, 1, 0, 0, 0);
  }
}

}  // namespace embed
