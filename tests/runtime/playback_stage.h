// A small application: its own device with validation, a colour target, a depth target and one uniform block.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/playback/player.h"
#include "runtime/vulkan/buffer.h"
#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/image.h"
#include "runtime/vulkan/readback.h"
#include "tests/runtime/small_recipes.h"

namespace reprise {

using Pixel = std::array<float, 4>;

// State of the application's pipeline that a test may change before a player is made of it.
struct PipelineState {
  PipelineState();
  PipelineState(const PipelineState&) = delete;
  PipelineState& operator=(const PipelineState&) = delete;

  VkPipelineVertexInputStateCreateInfo vertex_input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  VkPipelineColorBlendAttachmentState blend_attachment{};
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  VkGraphicsPipelineCreateInfo create_info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
};

class PlaybackStage : public testing::Test {
 protected:
  static constexpr std::uint32_t kSize = 16;

  void SetUp() override;
  // Fails the test if the validation layer said anything that the test did not expect.
  void TearDown() override;

  // Makes new targets of size by size pixels.
  void useTargets(std::uint32_t size, VkFormat depth_format);
  ApplicationPipeline pipeline() const;
  DeviceHandles handles() const;
  Player makePlayer(const Package& package, const PlayerOptions& options = {}) const;

  // Inputs of a frame with these draws, which must outlive its recording.
  FrameInputs inputs(const std::vector<Quad>& quads) const;
  void draw(PassContext& pass, const std::vector<Quad>& quads) const;
  // Records and runs one command buffer.
  void run(const std::function<Result<void>(VkCommandBuffer)>& record);
  void play(Player& player, const std::vector<Quad>& quads) { play(player, quads, inputs(quads)); }
  void play(Player& player, const std::vector<Quad>& quads, const FrameInputs& frame);
  // Makes earlier writes to the targets visible to what follows, as an application does between its frames.
  void separate(VkCommandBuffer commands) const;

  Pixel colorAt(std::uint32_t x, std::uint32_t y);
  Pixel resourceAt(const Player& player, const std::string& name, std::uint32_t x);

  const Context& context() const { return *context_; }
  std::vector<std::string> messages() const { return context_->validation_messages(); }

  PipelineState state_;
  bool expects_messages_ = false;
  bool uses_block_ = false;       // the application has set 0
  std::array<float, 4> block_{};  // the content of "Object"

 private:
  void createBlock();
  Pixel pixelOf(const ReadbackSource& source, std::uint32_t x, std::uint32_t y);

  std::unique_ptr<Context> context_;
  std::unique_ptr<Commands> commands_;
  std::uint32_t size_ = kSize;
  VkFormat depth_format_ = VK_FORMAT_D32_SFLOAT;
  Image color_, depth_;
  Buffer object_;
  Handle<VkDescriptorSetLayout> set_layout_;
  Handle<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};

}  // namespace reprise
