// One scenario of shaders/laws on a device, and variants of its first candidate played frame by frame.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "cli/subject.h"
#include "cli/train.h"
#include "profiler/session/scene_renderer.h"
#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/readback.h"

namespace reprise {

// Everything that one frame left behind.
struct PlayedFrame {
  std::vector<std::vector<float>> colors;  // by output: RGBA floats, exact for float formats, k/255 for 8 bits
  std::vector<std::vector<std::byte>> raw; // by output: the texels themselves
  std::vector<std::uint8_t> kind;          // 0 uncovered, 1 hit, 2 miss; empty for the original
  std::vector<std::uint8_t> age;           // of aged variants (VariantOptions::aged), else empty
  double shaded_hits = 0, shaded_misses = 0;
  std::vector<float> depth;                // where the depth format can be read back
};

class LawScene {
 public:
  // `validation`: the Khronos layer with synchronization validation. `magnified`: times the resolution.
  static std::unique_ptr<LawScene> open(const std::string& scenario_file, bool validation = false,
                                        std::uint32_t magnified = 1);

  const Subject& subject() const { return subject_; }
  const Context& context() const { return *context_; }
  Subject& subject() { return subject_; }
  // The kept candidate with the largest share that is not the whole shader: of the kind that the scenario is named for
  // (several_values, guarded, regrouped, integer, loop_result), else a single value that is computed for every pixel.
  const Candidate& candidate() const;
  ValueRanges ranges() const;

  std::unique_ptr<Player> player(const VariantOptions& options, const PlayerOptions& player_options = {});
  // A frame of the first training session; `frozen` plays frame 0 of it over and over.
  PlayedFrame play(Player& player, int frame, std::uint32_t period, bool frozen = false);

 private:
  Subject subject_;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Commands> commands_;
  std::unique_ptr<SceneRenderer> renderer_;
  std::unique_ptr<Readback> readback_;
  RenderTargets targets_;
};

// All scenario files of shaders/laws, sorted.
std::vector<std::string> lawScenarios();

// Options of the instrumented variant for one point of the matrix of laws.
VariantOptions lawOptions(const LawScene& scene, const std::string& strategy, PatternKind pattern, Filter filter, Encoding encoding);

}  // namespace reprise
