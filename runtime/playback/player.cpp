#include "runtime/playback/player.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "runtime/playback/draw_uniforms.h"
#include "runtime/playback/frame_rendering.h"
#include "runtime/playback/history_images.h"
#include "runtime/playback/miss_flags.h"
#include "runtime/playback/pass_pipelines.h"
#include "runtime/playback/pass_queries.h"
#include "runtime/playback/recording_pass.h"
#include "runtime/playback/requirements.h"
#include "runtime/playback/tile_flags.h"

namespace reprise {
namespace {

Result<Handle<VkSampler>> createSampler(const DeviceView& device, VkFilter filter) {
  VkSamplerCreateInfo create{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  create.magFilter = create.minFilter = filter;
  create.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
  create.addressModeU = create.addressModeV = create.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER;
  create.borderColor = VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK;  // depth 0: nothing valid
  create.unnormalizedCoordinates = VK_TRUE;
  VkSampler sampler = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateSampler(device.device, &create, nullptr, &sampler));
  return Handle<VkSampler>(device.device, sampler, device.fn.vkDestroySampler);
}

constexpr std::uint32_t kMostReadBindings = 14;  // bindings 2 to 15

// What one frame in flight owns: uniform memory, a descriptor set for each pass, and the flags of recipes that flag draws.
struct FrameSlot {
  UniformRegion uniforms;
  std::vector<VkDescriptorSet> sets;
  MissFlags draw_flags;
};

// What recording a frame carries from pass to pass.
struct FrameRecording {
  VkCommandBuffer commands;
  FrameSlot& slot;
  const MissFlags* flags;  // of this frame's misses; null where the recipe flags none
  bool wholly_due;
  RenderingParts parts;
  std::set<std::string> written = {};  // resources
  bool first_rendering = true, drawn = false;
};

}  // namespace

struct Player::State {
  DeviceView device;
  Package package;
  const Recipe* recipe = nullptr;
  std::string original_reason;
  ApplicationPipeline application;  // create_info is null once the pipelines are made
  PlayerOptions options;
  PassPipelines pipelines;
  Handle<VkSampler> nearest, linear;
  Handle<VkDescriptorPool> pool;
  std::vector<FrameSlot> slots;
  ImagesByName images;
  TileFlags tiles;  // of recipes that flag them
  VkExtent2D extent = {};
  VkDeviceSize uniform_alignment = 256;
  std::uint64_t frame = 0;
  bool history_valid = false;
  VkViewport previous_viewport = {};
  std::map<std::uint64_t, DrawBytes> last_draws;
  std::map<std::uint64_t, DrawPlace> places;  // of the frame being recorded
  const MissFlags* asked_flags = nullptr;     // those by which the last recorded frame draws objects

  Result<void> createDescriptors();
  Result<void> resize(VkExtent2D to);
  FrameUniforms uniformsOf(const FrameInputs& inputs) const;
  Result<void> writeUniforms(const FrameInputs& inputs, FrameSlot& slot);
  void updateSets(FrameSlot& slot);
  // The flags of this frame's misses; null where the recipe flags none.
  const MissFlags* flagsOf(const FrameSlot& slot) const;
  void prepareImages(VkCommandBuffer commands, const Pass& pass, bool first_use_of_frame, std::set<std::string>& written);
  // Whether any pass of the rendering draws in this frame.
  bool isRendered(const FrameRecording& recording, int rendering) const;
  void beginRenderingAt(FrameRecording& recording, std::size_t first);  // its first pass
  void recordPass(FrameRecording& recording, std::size_t index, const std::function<void(PassContext&)>& draw);
};

namespace {

// "texture albedo" is named by itself and by "albedo", "Scene.light" also by its block "Scene" and its member "light".
bool namesInput(const std::string& listed, const std::string& input) {
  const std::string name = listed.substr(listed.find(' ') + 1);
  return listed == input || name == input || name.starts_with(input + ".") || name.ends_with("." + input);
}

void appDependency(const DeviceView& device, VkCommandBuffer commands) {
  constexpr VkPipelineStageFlags kStages = VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT |
                                           VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT |
                          VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
  device.fn.vkCmdPipelineBarrier(commands, kStages, kStages, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

}  // namespace

Player::Player(std::unique_ptr<State> state) : state_(std::move(state)) {}
Player::Player(Player&&) noexcept = default;
Player& Player::operator=(Player&&) noexcept = default;
Player::~Player() = default;

Result<Player> Player::create(const DeviceHandles& handles, const Package& package, const ApplicationPipeline& pipeline,
                              const PlayerOptions& options) {
  REPRISE_TRY(checkPackage(package));
  REPRISE_TRY(checkApplication(package, pipeline));
  auto state = std::make_unique<State>();
  REPRISE_ASSIGN(state->device, viewDevice({handles.instance, handles.device, handles.get_instance_proc_addr, handles.get_device_proc_addr},
                                           handles.physical_device));
  state->package = package;
  state->options = options;
  state->application = pipeline;
  state->recipe = &state->package.variant;
  if (!options.force_original) state->original_reason = missingRequirement(state->device, *state->recipe, pipeline);
  if (options.force_original || !state->original_reason.empty()) state->recipe = &state->package.original;
  REPRISE_ASSIGN(state->pipelines, createPipelines(state->device, state->package, *state->recipe, pipeline));
  state->application.create_info = nullptr;
  VkPhysicalDeviceProperties properties;
  state->device.fn.vkGetPhysicalDeviceProperties(handles.physical_device, &properties);
  state->uniform_alignment = std::max<VkDeviceSize>(properties.limits.minUniformBufferOffsetAlignment, 16);
  state->slots.resize(std::max(options.frames_in_flight, 1u));
  if (state->recipe->uses_reprise_set) REPRISE_TRY(state->createDescriptors());
  return Player(std::move(state));
}

Result<void> Player::State::createDescriptors() {
  REPRISE_ASSIGN(nearest, createSampler(device, VK_FILTER_NEAREST));
  REPRISE_ASSIGN(linear, createSampler(device, VK_FILTER_LINEAR));
  const auto sets = static_cast<std::uint32_t>(slots.size() * recipe->passes.size());
  const std::vector<VkDescriptorPoolSize> sizes = {
      {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, sets},
      {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, sets * static_cast<std::uint32_t>(1 + recipe->previous_inputs.size())},
      {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, sets * kMostReadBindings},
      {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, sets}};
  VkDescriptorPoolCreateInfo create{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  create.maxSets = sets;
  create.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  create.pPoolSizes = sizes.data();
  VkDescriptorPool created = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateDescriptorPool(device.device, &create, nullptr, &created));
  pool = {device.device, created, device.fn.vkDestroyDescriptorPool};
  const std::vector<VkDescriptorSetLayout> layouts(recipe->passes.size(), pipelines.own_layouts.back().get());
  for (FrameSlot& slot : slots) {
    slot.sets.resize(recipe->passes.size());
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = created;
    allocate.descriptorSetCount = static_cast<std::uint32_t>(layouts.size());
    allocate.pSetLayouts = layouts.data();
    REPRISE_VK(device.fn.vkAllocateDescriptorSets(device.device, &allocate, slot.sets.data()));
  }
  return {};
}

Result<void> Player::State::resize(VkExtent2D to) {
  if (to.width == extent.width && to.height == extent.height) return {};
  // Frames in flight may still use the old images.
  if (!images.empty()) REPRISE_VK(device.fn.vkDeviceWaitIdle(device.device));
  REPRISE_ASSIGN(images, createResourceImages(device, *recipe, to));
  if (recipe->flags == MissFlagging::kTiles) REPRISE_TRY(tiles.resize(device, to));
  extent = to;
  history_valid = false;
  return {};
}

FrameUniforms Player::State::uniformsOf(const FrameInputs& inputs) const {
  FrameUniforms uniforms;
  const auto write = [](float (&to)[4], const VkViewport& viewport) {
    to[0] = viewport.x;
    to[1] = viewport.y;
    to[2] = viewport.width;
    to[3] = viewport.height;
  };
  uniforms.frame = static_cast<std::uint32_t>(frame);
  uniforms.period_frames = inputs.period_frames;
  uniforms.history_valid = history_valid ? 1 : 0;
  uniforms.due = dueBlocks({recipe->pattern, inputs.period_frames, recipe->block_pixels}, uniforms.frame,
                           static_cast<std::uint32_t>(inputs.viewport.width), static_cast<std::uint32_t>(std::abs(inputs.viewport.height)));
  if (recipe->flags == MissFlagging::kTiles) uniforms.tiles = tiles.across() | tiles.down() << 16;
  uniforms.free_payload = recipe->constants.free_payload;
  write(uniforms.viewport, inputs.viewport);
  write(uniforms.previous_viewport, history_valid ? previous_viewport : inputs.viewport);
  return uniforms;
}

Result<void> Player::State::writeUniforms(const FrameInputs& inputs, FrameSlot& slot) {
  REPRISE_ASSIGN(auto draws, collectDrawBytes(*recipe, inputs));
  REPRISE_TRY(slot.uniforms.reserve(device, *recipe, draws.size(), uniform_alignment));
  slot.uniforms.writeFrame(uniformsOf(inputs));
  if (recipe->flags == MissFlagging::kDraws)
    REPRISE_TRY(slot.draw_flags.reserve(device, std::max<std::uint32_t>(1, static_cast<std::uint32_t>(draws.size())), FlagReader::kConditions));
  places.clear();
  std::uint32_t index = 0;
  for (const auto& [id, bytes] : draws) {
    const auto last = last_draws.find(id);
    places[id] = {index, slot.uniforms.writeDraw(*recipe, index, last == last_draws.end() ? nullptr : &last->second, bytes)};
    ++index;
  }
  last_draws = std::move(draws);
  return {};
}

const MissFlags* Player::State::flagsOf(const FrameSlot& slot) const {
  switch (recipe->flags) {
    case MissFlagging::kNone: return nullptr;
    case MissFlagging::kTiles: return &tiles.flags();
    case MissFlagging::kDraws: return &slot.draw_flags;
  }
  return nullptr;
}

void Player::State::updateSets(FrameSlot& slot) {
  for (std::size_t pass = 0; pass < recipe->passes.size(); ++pass) {
    std::vector<VkDescriptorBufferInfo> buffers;
    std::vector<VkDescriptorImageInfo> image_infos;
    std::vector<VkWriteDescriptorSet> writes;
    buffers.reserve(recipe->previous_inputs.size() + 3);
    image_infos.reserve(kMostReadBindings);
    const auto add = [&](std::uint32_t binding, VkDescriptorType type) -> VkWriteDescriptorSet& {
      VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
      write.dstSet = slot.sets[pass];
      write.dstBinding = binding;
      write.descriptorCount = 1;
      write.descriptorType = type;
      writes.push_back(write);
      return writes.back();
    };
    const auto addBuffer = [&](std::uint32_t binding, VkDescriptorType type, const VkDescriptorBufferInfo& buffer) {
      buffers.push_back(buffer);
      add(binding, type).pBufferInfo = &buffers.back();
    };
    const VkBuffer memory = slot.uniforms.buffer();
    addBuffer(0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, {memory, 0, sizeof(FrameUniforms)});
    addBuffer(1, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, {memory, 0, UniformRegion::drawBlockBytes(*recipe)});
    for (const PreviousInput& input : recipe->previous_inputs)
      if (input.source == PreviousSource::kUniformBlock) addBuffer(input.reprise_binding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, {memory, 0, input.size_bytes});
    if (const MissFlags* flags = flagsOf(slot); flags != nullptr)
      addBuffer(kFlagsBinding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {flags->buffer(), 0, VK_WHOLE_SIZE});
    // Bindings that this pass does not read still get an image: another pass's, in the role that is safe to bind now.
    std::map<std::uint32_t, const Read*> reads;
    for (const Pass& other : recipe->passes)
      for (const Read& read : other.reads) reads.emplace(read.binding, &read);
    for (const Read& read : recipe->passes[pass].reads) reads[read.binding] = &read;
    for (const auto& [binding, read] : reads) {
      ResourceImages& resource = images.at(read->resource);
      const bool reads_it = std::find(recipe->passes[pass].reads.begin(), recipe->passes[pass].reads.end(), *read) != recipe->passes[pass].reads.end();
      TrackedImage& image = read->current && reads_it ? resource.written(frame) : resource.last(frame);
      image_infos.push_back({read->filter == Filter::kBilinear ? linear.get() : nearest.get(), image.image.view.get(),
                             VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
      add(binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER).pImageInfo = &image_infos.back();
    }
    device.fn.vkUpdateDescriptorSets(device.device, static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
  }
}

void Player::State::prepareImages(VkCommandBuffer commands, const Pass& pass, bool first_rendering, std::set<std::string>& written) {
  const bool omit = !first_rendering && options.omit_barrier_for_test;
  if (!first_rendering && !omit) appDependency(device, commands);
  for (const Read& read : pass.reads) {
    ResourceImages& resource = images.at(read.resource);
    transition(device, commands, read.current ? resource.written(frame) : resource.last(frame),
               {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false, omit});
  }
  for (const ColorAttachment& color : pass.colors) {
    if (color.resource.empty()) continue;
    const bool discard = color.load != LoadOp::kLoad && written.count(color.resource) == 0;
    transition(device, commands, images.at(color.resource).written(frame), {VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, discard, omit});
    written.insert(color.resource);
  }
}

bool Player::State::isRendered(const FrameRecording& recording, int rendering) const {
  return std::any_of(recipe->passes.begin(), recipe->passes.end(),
                     [&](const Pass& pass) { return pass.rendering == rendering && drawsIn(pass, recording.wholly_due); });
}

void Player::State::beginRenderingAt(FrameRecording& recording, std::size_t first) {
  const Pass& pass = recipe->passes[first];
  // Reads of later passes of this rendering count too: nothing can be transitioned inside it.
  Pass all = pass;
  for (std::size_t other = first + 1; other < recipe->passes.size() && recipe->passes[other].rendering == pass.rendering; ++other)
    all.reads.insert(all.reads.end(), recipe->passes[other].reads.begin(), recipe->passes[other].reads.end());
  const bool asks_flags = pass.kind == PassKind::kTiles || pass.objects == PassObjects::kFlagged;
  if (asks_flags && !options.omit_barrier_for_test) recording.flags->makeVisible(device, recording.commands);
  prepareImages(recording.commands, all, recording.first_rendering, recording.written);
  recording.first_rendering = false;
  beginRendering(device, recording.commands, pass, recording.parts);
}

void Player::State::recordPass(FrameRecording& recording, std::size_t index, const std::function<void(PassContext&)>& draw) {
  const Pass& pass = recipe->passes[index];
  if (!drawsIn(pass, recording.wholly_due)) return;
  const bool flagged_alone = pass.objects == PassObjects::kFlagged;
  if (flagged_alone) asked_flags = recording.flags;
  RecordingPass context({&device, recording.commands, pipelines.layout.get(), static_cast<int>(index), recipe->uses_reprise_set,
                         recipe->reprise_set, recipe->uses_reprise_set ? recording.slot.sets[index] : VK_NULL_HANDLE, &places,
                         flagged_alone ? recording.flags->buffer() : VK_NULL_HANDLE, &recording.drawn});
  if (pass.kind == PassKind::kDraw) {
    draw(context);
    context.endObject();
  } else if (recording.drawn) {
    // What no draw bound no tile can read: then there is nothing to finish either.
    context.bindDraw(places.begin()->first);
    tiles.drawTiles(device, recording.commands);
  }
}

Result<void> Player::record(VkCommandBuffer commands, const FrameInputs& inputs, const std::function<void(PassContext&)>& draw) {
  State& state = *state_;
  const DeviceView& device = state.device;
  const Recipe& recipe = *state.recipe;
  REPRISE_TRY(checkFrame(state.application, inputs));
  REPRISE_TRY(state.resize(inputs.extent));
  FrameSlot& slot = state.slots[state.frame % state.slots.size()];
  if (recipe.uses_reprise_set) {
    REPRISE_TRY(state.writeUniforms(inputs, slot));
    state.updateSets(slot);
  }
  const bool wholly_due = isWhollyDue({recipe.pattern, inputs.period_frames, recipe.block_pixels}, static_cast<std::uint32_t>(state.frame));
  FrameRecording recording{commands, slot, state.flagsOf(slot), wholly_due,
                           {&inputs, &state.images, state.frame, state.application.depth_format, recipe.requirements.stencil, {}, false}};
  const PassQueries queries(device, commands, inputs, static_cast<std::uint32_t>(recipe.passes.size()));
  state.asked_flags = nullptr;
  if (recording.flags != nullptr) recording.flags->clear(device, commands);
  for (std::uint32_t index = 0; index < recipe.passes.size(); ++index) {
    const int rendering = recipe.passes[index].rendering;
    const bool rendered = state.isRendered(recording, rendering);
    const bool begins = index == 0 || recipe.passes[index - 1].rendering != rendering;
    const bool ends = index + 1 == recipe.passes.size() || recipe.passes[index + 1].rendering != rendering;
    if (rendered && begins) state.beginRenderingAt(recording, index);
    if (rendered) device.fn.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, state.pipelines.pipelines[index].get());
    queries.beginCounting(index);
    state.recordPass(recording, index, draw);
    queries.endCounting(index);
    if (rendered && ends) device.fn.vkCmdEndRendering(commands);
    queries.stampEnd(index);
  }
  for (auto& [name, resource] : state.images)
    for (TrackedImage& image : resource.images) transition(device, commands, image, {});
  state.previous_viewport = inputs.viewport;
  state.history_valid = std::all_of(recipe.resources.begin(), recipe.resources.end(), [&](const Resource& resource) {
    return resource.lifetime == Lifetime::kFrame || recording.written.count(resource.name) != 0;
  });
  ++state.frame;
  return {};
}

void Player::invalidate() { state_->history_valid = false; }

void Player::invalidate(const std::string& input) {
  for (const PayloadValue& value : state_->recipe->payload)
    for (const std::string& name : value.inputs)
      if (namesInput(name, input)) invalidate();
}

void Player::restart() {
  invalidate();
  state_->frame = 0;
}

bool Player::playsOriginal() const { return state_->recipe == &state_->package.original || !state_->recipe->uses_reprise_set; }
const std::string& Player::originalReason() const { return state_->original_reason; }
const Recipe& Player::recipe() const { return *state_->recipe; }

std::optional<ResourceImage> Player::resource(const std::string& name) const {
  const auto found = state_->images.find(name);
  if (found == state_->images.end() || state_->frame == 0) return std::nullopt;
  const TrackedImage& image = found->second.written(state_->frame - 1);
  return ResourceImage{image.image.image.get(), image.image.view.get(), image.image.format,
                       {image.image.extent.width, image.image.extent.height}, image.layout};
}

std::optional<FlaggedDraws> Player::flaggedDraws() const {
  if (state_->asked_flags == nullptr) return std::nullopt;
  const auto drawn = static_cast<std::uint32_t>(state_->places.size());
  return FlaggedDraws{drawn, state_->asked_flags->countSet(drawn)};
}

}  // namespace reprise
