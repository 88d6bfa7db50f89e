#include "cli/check/endless_loops.h"

#include "cli/check/frame_laws.h"
#include "cli/check/harness_program.h"
#include "compiler/ir/limit_loops.h"
#include "compiler/strategies/build_package.h"

namespace reprise {
namespace {

constexpr int kFrames = 6;
constexpr double kOtherColour = 1e-3;

class OriginalPlayer {
 public:
  OriginalPlayer(std::uint32_t seed, const Context& context, Commands& commands) : seed_(seed), context_(context), commands_(commands) {}

  Result<std::vector<HarnessFrame>> play(const CompiledShader& fragment) {
    REPRISE_ASSIGN(const ShaderProgram program, harnessProgram(fragment));
    HarnessOptions options;
    options.seed = seed_;
    REPRISE_ASSIGN(Harness harness, Harness::create(context_, commands_, program.interface, options));
    VariantOptions original;
    original.strategy = "original";
    REPRISE_ASSIGN(const Package package, buildPackage(program, {}, original, {true, true, true}));
    REPRISE_ASSIGN(Player player, harness.createPlayer(package, true));
    std::vector<HarnessFrame> frames;
    for (int frame = 0; frame < kFrames; ++frame) {
      REPRISE_ASSIGN(HarnessFrame played, harness.play(player, {frame, 1}));
      frames.push_back(std::move(played));
    }
    return frames;
  }

 private:
  std::uint32_t seed_;
  const Context& context_;
  Commands& commands_;
};

bool hasLoops(const Module& module) {
  for (const Function& function : module.functions)
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions)
        if (instruction.opcode == spv::Op::OpLoopMerge) return true;
  return false;
}

CompiledShader with(const CompiledShader& shader, const Module& module) {
  CompiledShader result = shader;
  result.words = writeModule(module);
  return result;
}

}  // namespace

Result<bool> loopsEndlessly(const CompiledShader& fragment, std::uint32_t seed, const Context& context, Commands& commands) {
  REPRISE_ASSIGN(const Module module, readModule(fragment.words));
  if (!hasLoops(module)) return false;
  OriginalPlayer player(seed, context, commands);
  REPRISE_ASSIGN(const std::vector<HarnessFrame> given, player.play(fragment));
  REPRISE_ASSIGN(const std::vector<HarnessFrame> limited, player.play(with(fragment, limitLoops(module, kEndlessIterations))));
  for (std::size_t frame = 0; frame < given.size(); ++frame)
    if (given[frame].depth != limited[frame].depth || !sameColors(given[frame], limited[frame], kOtherColour)) return true;
  return false;
}

}  // namespace reprise
