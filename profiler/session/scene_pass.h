// One pass before the shader, on a device.
#pragma once

#include <memory>

#include "profiler/scene/frame_state.h"
#include "profiler/session/pass_textures.h"
#include "runtime/vulkan/commands.h"

namespace reprise {

class ScenePass {
 public:
  virtual ~ScenePass() = default;
  // Fills uniform memory for a frame of the whole scene; the pass sees it in its own way.
  virtual void setFrame(const SessionSpec& session, const FrameState& state) = 0;
  // Renders; afterwards the textures of the pass can be sampled.
  virtual Result<void> record(VkCommandBuffer commands) = 0;
};

// What every pass is made from; all of it must outlive the pass.
struct PassParts {
  const Context* context = nullptr;
  Commands* commands = nullptr;
  const Scenario* scenario = nullptr;
  std::shared_ptr<const PassTextures> textures;
  std::size_t pass = 0;
};

}  // namespace reprise
