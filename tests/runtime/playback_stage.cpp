#include "tests/runtime/playback_stage.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace reprise {
namespace {

constexpr VkFormat kColorFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkPushConstantRange kPushRange{VK_SHADER_STAGE_VERTEX_BIT, 0, 32};

template <typename T>
T valueOf(Result<T> result) {
  REPRISE_CHECK(result.ok(), formatError(result.error()));
  return std::move(result).value();
}

// All of a quad but its id.
std::span<const std::byte> pushBytes(const Quad& quad) {
  static_assert(offsetof(Quad, rect) + kPushRange.size == sizeof(Quad));
  return std::as_bytes(std::span(&quad, 1)).subspan(offsetof(Quad, rect), kPushRange.size);
}

}  // namespace

PipelineState::PipelineState() {
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  raster.cullMode = VK_CULL_MODE_NONE;
  raster.lineWidth = 1;
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
  depth.depthCompareOp = VK_COMPARE_OP_LESS;
  blend_attachment.colorWriteMask = 0xf;
  blend.attachmentCount = 1;
  blend.pAttachments = &blend_attachment;
  create_info.pVertexInputState = &vertex_input;
  create_info.pInputAssemblyState = &assembly;
  create_info.pRasterizationState = &raster;
  create_info.pMultisampleState = &samples;
  create_info.pDepthStencilState = &depth;
  create_info.pColorBlendState = &blend;
}

void PlaybackStage::SetUp() {
  ContextOptions options;
  options.validation = true;
  context_ = std::make_unique<Context>(valueOf(Context::create(options)));
  commands_ = std::make_unique<Commands>(valueOf(Commands::create(*context_)));
  createBlock();
  useTargets(kSize, VK_FORMAT_D32_SFLOAT);
}

void PlaybackStage::TearDown() {
  if (expects_messages_) return;
  for (const std::string& message : messages()) ADD_FAILURE() << message;
}

void PlaybackStage::createBlock() {
  const DeviceView& device = context_->view();
  object_ = valueOf(createBuffer(device, sizeof block_, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT));
  const VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, VK_SHADER_STAGE_VERTEX_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo layout_create{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  layout_create.bindingCount = 1;
  layout_create.pBindings = &binding;
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  REPRISE_CHECK(device.fn.vkCreateDescriptorSetLayout(device.device, &layout_create, nullptr, &layout) == VK_SUCCESS, "vkCreateDescriptorSetLayout");
  set_layout_ = {device.device, layout, device.fn.vkDestroyDescriptorSetLayout};
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1};
  VkDescriptorPoolCreateInfo pool_create{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool_create.maxSets = pool_create.poolSizeCount = 1;
  pool_create.pPoolSizes = &size;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  REPRISE_CHECK(device.fn.vkCreateDescriptorPool(device.device, &pool_create, nullptr, &pool) == VK_SUCCESS, "vkCreateDescriptorPool");
  pool_ = {device.device, pool, device.fn.vkDestroyDescriptorPool};
  VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool;
  allocate.descriptorSetCount = 1;
  allocate.pSetLayouts = &layout;
  REPRISE_CHECK(device.fn.vkAllocateDescriptorSets(device.device, &allocate, &set_) == VK_SUCCESS, "vkAllocateDescriptorSets");
  const VkDescriptorBufferInfo buffer{object_.buffer.get(), 0, sizeof block_};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set_;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  write.pBufferInfo = &buffer;
  device.fn.vkUpdateDescriptorSets(device.device, 1, &write, 0, nullptr);
}

void PlaybackStage::useTargets(std::uint32_t size, VkFormat depth_format) {
  size_ = size;
  depth_format_ = depth_format;
  ImageDescription description;
  description.extent = {size, size, 1};
  description.format = kColorFormat;
  description.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  color_ = valueOf(createImage(context_->view(), description));
  description.format = depth_format;
  description.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  description.aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
  if (depth_format != VK_FORMAT_D32_SFLOAT) description.aspect |= VK_IMAGE_ASPECT_STENCIL_BIT;
  depth_ = valueOf(createImage(context_->view(), description));
  run([&](VkCommandBuffer commands) -> Result<void> {
    const DeviceView& device = context_->view();
    changeLayout(device, commands, {color_.image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL});
    changeLayout(device, commands, {depth_.image.get(), VK_IMAGE_LAYOUT_UNDEFINED,
                                    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, description.aspect});
    return {};
  });
}

ApplicationPipeline PlaybackStage::pipeline() const {
  ApplicationPipeline pipeline;
  pipeline.create_info = &state_.create_info;
  pipeline.push_constants = {kPushRange};
  pipeline.color_formats = {kColorFormat};
  pipeline.depth_format = depth_format_;
  pipeline.conditional_rendering = context_->has_conditional_rendering();
  return pipeline;
}

DeviceHandles PlaybackStage::handles() const {
  const FunctionSource functions = context_->functions();
  return {functions.instance, context_->view().physical_device, functions.device, functions.get_instance_proc_addr,
          functions.get_device_proc_addr};
}

Player PlaybackStage::makePlayer(const Package& package, const PlayerOptions& options) const {
  ApplicationPipeline application = pipeline();
  if (uses_block_) application.set_layouts = {set_layout_.get()};
  return valueOf(Player::create(handles(), package, application, options));
}

FrameInputs PlaybackStage::inputs(const std::vector<Quad>& quads) const {
  FrameInputs frame;
  frame.extent = {size_, size_};
  frame.viewport = {0, 0, static_cast<float>(size_), static_cast<float>(size_), 0, 1};
  frame.colors.resize(1);
  frame.colors[0].view = color_.view.get();
  frame.depth.view = depth_.view.get();
  for (const Quad& quad : quads) {
    DrawInputs inputs;
    inputs.id = quad.id;
    inputs.blocks = {{0, 0, std::as_bytes(std::span(block_))}};
    inputs.push_constants = pushBytes(quad);
    frame.draws.push_back(inputs);
  }
  return frame;
}

void PlaybackStage::draw(PassContext& pass, const std::vector<Quad>& quads) const {
  const DeviceView& device = context_->view();
  for (const Quad& quad : quads) {
    if (uses_block_)
      device.fn.vkCmdBindDescriptorSets(pass.commands(), VK_PIPELINE_BIND_POINT_GRAPHICS, pass.layout(), 0, 1, &set_, 0, nullptr);
    device.fn.vkCmdPushConstants(pass.commands(), pass.layout(), kPushRange.stageFlags, 0, kPushRange.size, pushBytes(quad).data());
    pass.bindDraw(quad.id);
    device.fn.vkCmdDraw(pass.commands(), 6, 1, 0, 0);
  }
}

void PlaybackStage::run(const std::function<Result<void>(VkCommandBuffer)>& record) {
  const Result<void> ran = commands_->run(record);
  ASSERT_TRUE(ran.ok()) << formatError(ran.error());
}

void PlaybackStage::play(Player& player, const std::vector<Quad>& quads, const FrameInputs& frame) {
  std::memcpy(object_.mapped.data(), block_.data(), sizeof block_);
  run([&](VkCommandBuffer commands) { return player.record(commands, frame, [&](PassContext& pass) { draw(pass, quads); }); });
}

void PlaybackStage::separate(VkCommandBuffer commands) const {
  VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
  barrier.dstAccessMask = barrier.srcAccessMask | VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
  constexpr VkPipelineStageFlags kStages = VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT |
                                           VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  context_->view().fn.vkCmdPipelineBarrier(commands, kStages, kStages, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

Pixel PlaybackStage::pixelOf(const ReadbackSource& source, std::uint32_t x, std::uint32_t y) {
  Readback readback(*context_);
  const auto bytes = valueOf(readback.read(*commands_, source));
  const std::vector<float> texels = toFloats(bytes, source.format);
  Pixel pixel;
  std::copy_n(texels.begin() + static_cast<std::ptrdiff_t>(4 * (y * source.extent.width + x)), 4, pixel.begin());
  return pixel;
}

Pixel PlaybackStage::colorAt(std::uint32_t x, std::uint32_t y) {
  return pixelOf({color_.image.get(), kColorFormat, {size_, size_}, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}, x, y);
}

Pixel PlaybackStage::resourceAt(const Player& player, const std::string& name, std::uint32_t x) {
  const std::optional<ResourceImage> found = player.resource(name);
  REPRISE_CHECK(found.has_value(), name);
  return pixelOf({found->image, found->format, found->extent, found->layout}, x, 0);
}

}  // namespace reprise
