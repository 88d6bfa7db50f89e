// A scenario with passes, made by a test, on a device with validation: its frames as numbers.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/subject.h"
#include "profiler/session/scene_renderer.h"
#include "runtime/vulkan/commands.h"
#include "tests/e2e/run_command.h"

namespace reprise {

class PassScene {
 public:
  // files: name and text of the shaders; scenario: TOML that names them. Its targets must be rgba32_sfloat.
  PassScene(const std::vector<std::pair<std::string, std::string>>& files, const std::string& scenario);

  const Subject& subject() const { return *subject_; }
  const Context& context() const { return *context_; }
  const std::filesystem::path& folder() const { return folder_.path(); }
  // A player of the original, or of a variant.
  std::unique_ptr<Player> player(const VariantOptions& options) const;
  Package package(const VariantOptions& options) const;
  // A frame of the first session: RGBA of every pixel, rows from the top.
  std::vector<float> play(Player& player, int frame, std::uint32_t period_frames = 1);
  // The same by the original.
  std::vector<float> original(int frame);

 private:
  TemporaryFolder folder_;
  std::unique_ptr<Subject> subject_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Commands> commands_;
  std::unique_ptr<SceneRenderer> renderer_;
  RenderTargets targets_;
};

VariantOptions asGiven();

}  // namespace reprise
