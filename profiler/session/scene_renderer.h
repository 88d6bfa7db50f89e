// The profiler as an application: renders the frames of a session through runtime/playback, the very code that ships.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "profiler/scene/frame_state.h"
#include "profiler/session/render_targets.h"
#include "profiler/session/scene_objects.h"
#include "runtime/playback/player.h"

namespace reprise {

// Queries of one frame; null handles: none.
struct FrameQueries {
  VkQueryPool timestamps = VK_NULL_HANDLE;
};

class SceneRenderer {
 public:
  // scenario and interface must outlive the renderer. Errors: as createSceneObjects.
  static Result<SceneRenderer> create(const Context& context, Commands& commands, const Scenario& scenario, const ShaderInterface& interface);
  // The same with the textures of passes that another renderer has made.
  static Result<SceneRenderer> create(const Context& context, Commands& commands, const SceneSource& source);
  SceneRenderer(SceneRenderer&&) noexcept;
  ~SceneRenderer();

  // Before the first frame of a scenario with passes. original: whose vertex shader the shadow passes use; packages: of the G-buffer
  // passes, by pass. Errors: those of Player::create.
  Result<void> createPasses(Commands& commands, const Package& original, std::span<const Package> packages);
  bool hasPasses() const;

  Result<RenderTargets> createTargets(Commands& commands) const;
  // A player for this scene's pipeline.
  Result<Player> createPlayer(const Package& package, const PlayerOptions& options) const;

  // Fills uniform memory for a frame; the same for every player of that frame.
  void setFrame(const SessionSpec& session, const FrameState& state);
  // Records the passes before the shader, once for all players of the frame that setFrame set.
  Result<void> recordPasses(VkCommandBuffer commands) const;
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
