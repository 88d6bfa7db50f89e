#include "cli/check/endless_loops.h"

#include "cli/check/frame_laws.h"
#include "cli/check/harness_program.h"
#include "cli/check/reference/play_original.h"
#include "compiler/ir/limit_loops.h"
#include "compiler/source/reflect.h"

namespace reprise {
namespace {

constexpr int kFrames = 6;
constexpr double kOtherColour = 1e-3;

class OriginalPlayer {
 public:
  OriginalPlayer(const HarnessOptions& inputs, const Context& context, Commands& commands) : inputs_(inputs), context_(context), commands_(commands) {}

  Result<std::vector<HarnessFrame>> play(const CompiledShader& fragment) {
    REPRISE_ASSIGN(const CompiledShader vertex, harnessVertex(fragment));
    ReflectOptions lenient;
    lenient.skip_unknown_members = lenient.any_arrays = lenient.any_bindings = true;
    REPRISE_ASSIGN(const ShaderInterface interface, reflectInterface(vertex.words, fragment.words, lenient));
    REPRISE_ASSIGN(Harness harness, Harness::create(context_, commands_, interface, inputs_));
    return playOriginal(harness, {interface, vertex.words, fragment.words}, kFrames);
  }

 private:
  const HarnessOptions& inputs_;
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

Result<bool> loopsEndlessly(const CompiledShader& fragment, const HarnessOptions& inputs, const Context& context, Commands& commands) {
  REPRISE_ASSIGN(const Module module, readModule(fragment.words));
  if (!hasLoops(module)) return false;
  OriginalPlayer player(inputs, context, commands);
  REPRISE_ASSIGN(const std::vector<HarnessFrame> given, player.play(fragment));
  REPRISE_ASSIGN(const std::vector<HarnessFrame> limited, player.play(with(fragment, limitLoops(module, kEndlessIterations))));
  for (std::size_t frame = 0; frame < given.size(); ++frame)
    if (given[frame].depth != limited[frame].depth || !sameColors(given[frame], limited[frame], kOtherColour)) return true;
  return false;
}

}  // namespace reprise
