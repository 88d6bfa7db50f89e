// The profiler as an application: renders the frames of a session through runtime/playback, the very code that ships.
#pragma once

#include <memory>
#include <vector>

#include "profiler/scene/frame_state.h"
#include "profiler/session/scene_objects.h"
#include "runtime/playback/player.h"

namespace reprise {

// Colour and depth targets of one frame, in attachment layouts.
struct RenderTargets {
  std::vector<Image> colors;
  Image depth;
  VkExtent2D extent = {};
};

// Queries of one frame; null handles: none.
struct FrameQueries {
  VkQueryPool timestamps = VK_NULL_HANDLE;
};

class SceneRenderer {
 public:
  // scenario and interface must outlive the renderer. Errors: as createSceneObjects.
  static Result<SceneRenderer> create(const Context& context, Commands& commands, const Scenario& scenario, const ShaderInterface& interface);
  SceneRenderer(SceneRenderer&&) noexcept;
  ~SceneRenderer();

  Result<RenderTargets> createTargets(Commands& commands) const;
  // A player for this scene's pipeline.
  Result<Player> createPlayer(const Package& package, const PlayerOptions& options) const;

  // Fills uniform memory for a frame; the same for every player of that frame.
  void setFrame(const SessionSpec& session, const FrameState& state);
  // Records the frame that setFrame set.
  Result<void> record(VkCommandBuffer commands, Player& player, const RenderTargets& targets, std::uint32_t period_frames,
                      const FrameQueries& queries) const;

  VkFormat colorFormat(std::size_t target) const;
  VkFormat depthFormat() const;
  float clearDepth() const;

 private:
  struct State;
  explicit SceneRenderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace reprise
