// The application's renderer, and the one place that knows of Reprise.
//
// Without Reprise it would make a VkPipeline from its shaders, begin rendering, bind the pipeline and draw
// its objects. With Reprise the player does the first three, several times a frame if the cached variant has
// several passes, and calls back to have the objects drawn. Targets, buffers and descriptor sets stay the
// application's.
#pragma once

#include <runtime/package/package.h>
#include <runtime/playback/player.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene.h"
#include "targets.h"
#include "vulkan_app.h"

namespace embed {

enum class Mode { kCached, kOriginal };

class Renderer {
 public:
  // Throws std::runtime_error with Reprise's message where the package cannot be played on this device.
  Renderer(VulkanApp& app, const reprise::Package& package, Mode mode);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // Renders one frame and returns its pixels: rows from the top, four bytes (RGBA) a pixel.
  std::vector<std::uint8_t> renderFrame(int frame);

  const reprise::Player& player() const { return *player_; }

 private:
  struct ObjectBuffers {
    Buffer vertices, indices;
    std::uint32_t index_count = 0;
  };

  void createDescriptorSet();
  void createPlayer(const reprise::Package& package, Mode mode);
  void record(VkCommandBuffer commands);
  void drawObjects(reprise::PassContext& pass) const;

  VulkanApp& app_;
  Targets targets_;
  std::vector<ObjectBuffers> object_buffers_;      // by object of the scene
  std::vector<ObjectConstants> object_constants_;  // of the frame that is recorded, by object
  FrameBlock frame_block_;                         // of the frame that is recorded
  Buffer frame_buffer_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  std::optional<reprise::Player> player_;
};

}  // namespace embed
