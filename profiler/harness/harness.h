// A made-up application for a shader that comes without one: meshes, inputs of every kind, and a camera that moves.
//
// Two meshes before a third, in motion before a camera in motion, draw with the vertex shader of compiler/source/harness_vertex.h,
// whose block is the descriptor named HarnessScene. Everything else that the shader reads is filled from the seed: uniform and
// storage blocks by the types of their members, push constants, images of every dimension with mip levels or samples, texel buffers,
// samplers; in a style that the seed chooses (made_up_values.h). Uniform blocks and push constants drift from frame to frame. Colour targets are 32 bits a channel, of the output's kind;
// the depth target has stencil. The same seed gives the same frames.
#pragma once

#include <memory>
#include <vector>

#include "profiler/harness/integer_inputs.h"
#include "runtime/package/package.h"
#include "runtime/playback/player.h"
#include "runtime/vulkan/commands.h"

namespace reprise {

struct HarnessOptions {
  std::uint32_t seed = 1;
  std::uint32_t width = 64, height = 64;
  IntegerAssignment integers;  // in place of made-up ones
};

struct HarnessFrame {
  std::vector<std::vector<std::uint32_t>> colors;  // by output: four words a pixel, rows from the top
  std::vector<std::uint32_t> depth;                // bits of the depth buffer
  std::vector<std::uint8_t> kind;                  // of instrumented variants: 0 uncovered, 1 hit, 2 miss
};

class Harness {
 public:
  // context, commands and interface must outlive it. Errors (kInput): harness.unsupported, an input that cannot be made up;
  // device.* (kMachine).
  static Result<Harness> create(const Context& context, Commands& commands, const ShaderInterface& interface, const HarnessOptions& options);
  Harness(Harness&&) noexcept;
  ~Harness();

  Result<Player> createPlayer(const Package& package, bool original) const;

  struct Shot {
    int frame = 0;                    // where camera and meshes are
    std::uint32_t period_frames = 1;
  };
  // Plays one frame and reads everything back. Errors: those of Player::record, device.timeout, device.lost.
  Result<HarnessFrame> play(Player& player, const Shot& shot);

 private:
  struct State;
  explicit Harness(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace reprise
