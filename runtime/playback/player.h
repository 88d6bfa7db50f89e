// Plays a package inside an application's own command buffer.
//
//   auto player = Player::create(device, package, pipeline, {});
//   ... every frame, outside a render pass:
//   player->record(commands, frame, [&](PassContext& pass) {
//     // once per draw pass that the frame needs: bind what the original draw binds, with pass.layout(), then for each object
//     pass.bindDraw(draw_id);  vkCmdDrawIndexed(...);
//   });
//
// The application owns colour targets, depth target, vertex and uniform buffers and its descriptor sets; the player owns
// histories, its pipelines (derived from the application's create-info) and one descriptor set (recipe.h). The player
// records and never submits. It keeps the bytes of last frame's uniform blocks and push constants itself: the application
// hands over this frame's with each draw, by draw id, which must name the same object from frame to frame.
//
// A package for stereo (recipe().previous is kOtherEye) is recorded once for each eye: left, right, left, right, ... from the first
// frame on, both eyes of a moment with what they share unchanged. The left eye is computed as a whole, the right one takes from it
// what both can see. A frame left out swaps the roles of the eyes: the images stay right, the errors change sides.
//
// Requires Vulkan 1.3 or VK_KHR_dynamic_rendering with synchronization2 enabled on the device. Where the package's other
// requirements are missing the original is played and playsOriginal() says why.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/package/package.h"

namespace reprise {

struct DeviceHandles {
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physical_device = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
  PFN_vkGetDeviceProcAddr get_device_proc_addr = nullptr;
};

// The application's pipeline for the original shader: vertex input, input assembly, rasterization, multisample, depth
// and colour state are taken from `create_info` (stages, layout, render pass and dynamic state are the player's; viewport
// and scissor are dynamic). set_layouts are the application's sets 0..; push_constants its ranges.
struct ApplicationPipeline {
  const VkGraphicsPipelineCreateInfo* create_info = nullptr;
  std::vector<VkDescriptorSetLayout> set_layouts;
  std::vector<VkPushConstantRange> push_constants;
  std::vector<VkFormat> color_formats;
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;
  // The application's word, which packages of strategy repair need: what the fragment shader reads besides its varyings (descriptors,
  // push constants) is the same for all draws of a frame, and the device has fragmentStoresAndAtomics enabled. The misses of all draws
  // are then finished by one draw of the player's own, with the sets and push constants that the last of them left bound.
  bool draws_share_inputs = false;
  // The application's word, which packages of strategy two_pass_objects need: the device has VK_EXT_conditional_rendering with its feature
  // conditionalRendering and fragmentStoresAndAtomics enabled, and draw callbacks use no conditional rendering of their own.
  bool conditional_rendering = false;
  // The application's word, which packages need that reject a part of a quad under a shader whose derivatives depend on storage buffers: on
  // this device lanes that early tests reject load from storage buffers (runtime/vulkan/lane_probe.h finds out).
  bool rejected_lanes_load = false;
};

struct ColorTarget {
  VkImageView view = VK_NULL_HANDLE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  VkClearColorValue clear = {};
  bool load = false;  // keep what is there instead of clearing
};

struct DepthTarget {
  VkImageView view = VK_NULL_HANDLE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
  float clear_depth = 1;
  bool load = false;
};

// This frame's content of one uniform block that the recipe's previous_inputs names. bytes must cover size_bytes.
struct BlockBytes {
  std::uint32_t set = 0;
  std::uint32_t binding = 0;
  std::span<const std::byte> bytes;
};

// One object of the frame. blocks: the listed blocks as this draw sees them (the same bytes for all draws where a block is
// per frame). push_constants: this draw's, where the recipe lists them.
struct DrawInputs {
  std::uint64_t id = 0;
  std::vector<BlockBytes> blocks;
  std::span<const std::byte> push_constants;
};

struct FrameInputs {
  VkExtent2D extent = {};
  VkViewport viewport = {};      // height may be negative
  std::vector<ColorTarget> colors;
  DepthTarget depth;
  std::uint32_t period_frames = 1;   // kNeverRefresh: never
  std::vector<DrawInputs> draws;
  VkQueryPool timestamps = VK_NULL_HANDLE;  // optional: passes+1 timestamps written from first_query on
  std::uint32_t first_query = 0;
  VkQueryPool occlusion = VK_NULL_HANDLE;   // optional: one precise occlusion query per pass from first_occlusion on
  std::uint32_t first_occlusion = 0;
};

class PassContext {
 public:
  virtual ~PassContext() = default;
  virtual VkCommandBuffer commands() const = 0;
  virtual VkPipelineLayout layout() const = 0;  // compatible with the application's for its own sets
  virtual int pass() const = 0;                 // index into the recipe's passes
  // Binds Reprise's set for this object; id must be in FrameInputs::draws. What is drawn from here to the next bindDraw is this object's:
  // a pass for misses may leave it out.
  virtual void bindDraw(std::uint64_t id) = 0;
};

struct PlayerOptions {
  std::uint32_t frames_in_flight = 2;
  bool force_original = false;
  // Leaves out the dependencies between rendering instances, so that a test can show that validation would notice.
  bool omit_barrier_for_test = false;
};

// An image of the player's, for read-back by tools. In layout SHADER_READ_ONLY_OPTIMAL after record(); usage has TRANSFER_SRC.
struct ResourceImage {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent = {};
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

// Of the draws of a frame, those with a miss. Fragments that something hides count too.
struct FlaggedDraws {
  std::uint32_t drawn = 0, flagged = 0;
};

class Player {
 public:
  // Errors: as checkPackage; player.pipeline (kInput: create_info lacks state, or has fewer colour formats than the shader has
  // outputs); device.function, device.memory, device.call (kMachine).
  static Result<Player> create(const DeviceHandles& device, const Package& package,
                               const ApplicationPipeline& pipeline, const PlayerOptions& options = {});
  Player(Player&&) noexcept;
  Player& operator=(Player&&) noexcept;
  ~Player();  // the application has waited for the frames in flight

  // Records one frame. Errors (kMachine): device memory for histories; (kInput): player.input_missing (a block or push
  // constants of a draw), player.draw_id (one id for two draws), player.extent, player.target_missing. Nothing is recorded
  // then. A new extent makes new histories and invalidates; the viewport may change from frame to frame.
  Result<void> record(VkCommandBuffer commands, const FrameInputs& frame,
                      const std::function<void(PassContext&)>& draw);

  void invalidate();                          // cut: the next frame is all misses
  // A changed light or texture: all misses if the payload depends on it. `input` as PayloadValue::inputs spells it, or a
  // block, member or texture name alone.
  void invalidate(const std::string& input);
  // What follows is played as after create(): all misses first, and the refresh pattern begins anew.
  void restart();
  bool playsOriginal() const;
  const std::string& originalReason() const;  // empty unless requirements were missing
  const Recipe& recipe() const;               // the one that is played
  // The image that the last recorded frame wrote; nullopt for a name that the recipe does not have.
  std::optional<ResourceImage> resource(const std::string& name) const;
  // Of the last recorded frame, which the device has finished; nullopt where no pass of it draws flagged objects.
  std::optional<FlaggedDraws> flaggedDraws() const;

 private:
  struct State;
  explicit Player(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace reprise
