#include "cli/check/divergent_quads.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/divergence_warnings.h"
#include "compiler/ir/globals.h"
#include "compiler/strategies/build_package.h"
#include "compiler/transforms/link_frame.h"
#include "compiler/transforms/redirect_variable.h"

namespace reprise {
namespace {

using spv::Op;

// After the body all lanes are together again. The second step reaches the lane across the diagonal.
constexpr const char* kFrame = R"(#version 450
layout(location = 0) out vec4 reprise_parted;
uint reprise_trace;
void reprise_body() {}
float spread(float value) { return abs(dFdxFine(value)) + abs(dFdyFine(value)); }
void main() {
  reprise_trace = 0u;
  reprise_body();
  float apart = spread(float((reprise_trace ^ reprise_trace >> 8) & 0xffffffu)) > 0.0 ? 1.0 : 0.0;
  apart += spread(apart);
  reprise_parted = vec4(apart > 0.0 ? 1.0 : 0.0);
}
)";

Result<Module> compileTracingFrame() {
  CompileOptions options;
  options.stage = ShaderStage::kFragment;
  REPRISE_ASSIGN(const CompiledShader compiled, compileText(kFrame, "parted.frag", options));
  return readModule(compiled.words);
}

class Tracer {
 public:
  Tracer(Module& module, std::uint32_t variable)
      : module_(module), variable_(variable), uint_(uintType(module)), factor_(uintConstant(module, 1664525)) {}

  // Before the branch of `block`, and before the merge that belongs to it: trace = trace * factor + which way it goes.
  void trace(Block& block, std::uint32_t number) {
    const Instruction terminator = block.terminator();
    if (terminator.opcode != Op::OpBranchConditional && terminator.opcode != Op::OpSwitch) return;
    std::vector<Instruction> added;
    const auto compute = [&](Op opcode, std::uint32_t type, std::vector<Operand> operands) {
      added.push_back(makeInstruction(opcode, type, module_.freshId(), std::move(operands)));
      return idOperand(added.back().result_id);
    };
    Operand way;
    if (terminator.opcode == Op::OpBranchConditional) {
      const Operand yes = idOperand(uintConstant(module_, 2 * number + 1)), no = idOperand(uintConstant(module_, 2 * number + 2));
      way = compute(Op::OpSelect, uint_, {terminator.operands[0], yes, no});
    } else {
      way = selector(terminator.word(0), compute);
    }
    const Operand before = compute(Op::OpLoad, uint_, {idOperand(variable_)});
    const Operand moved = compute(Op::OpIMul, uint_, {before, idOperand(factor_)});
    const Operand after = compute(Op::OpIAdd, uint_, {moved, way});
    added.push_back(makeInstruction(Op::OpStore, 0, 0, {idOperand(variable_), after}));
    auto at = block.instructions.end() - 1;
    if (at != block.instructions.begin() && ((at - 1)->opcode == Op::OpSelectionMerge || (at - 1)->opcode == Op::OpLoopMerge)) --at;
    block.instructions.insert(at, added.begin(), added.end());
  }

 private:
  template <typename Compute>
  Operand selector(std::uint32_t id, const Compute& compute) {
    const Instruction* type = findGlobal(module_, resultTypes(module_).at(id));
    const bool is_uint = type->result_id == uint_;
    if (is_uint) return idOperand(id);
    return type->word(0) == 32 ? compute(Op::OpBitcast, uint_, {idOperand(id)}) : compute(type->word(1) != 0 ? Op::OpSConvert : Op::OpUConvert, uint_, {idOperand(id)});
  }

  Module& module_;
  std::uint32_t variable_, uint_, factor_;
};

Result<Module> tracingModule(const ShaderProgram& program) {
  const PreparedShader& shader = *program.fragment;
  REPRISE_ASSIGN(Module module, hideOutputs(shader.module, shader.entry_function, HiddenOutputs::kColors));
  const std::uint32_t variable = addVariable(module, spv::StorageClass::Private, uintType(module), "trace");
  Tracer tracer(module, variable);
  for (const int block : program.analysis.divergence.deciders)
    tracer.trace(findFunction(module, shader.entry_function)->blocks[static_cast<std::size_t>(block)], static_cast<std::uint32_t>(block));
  REPRISE_ASSIGN(const Module frame, compileTracingFrame());
  FrameBindings bindings;
  bindings.functions = {{"reprise_body", shader.entry_function}};
  bindings.variables = {{"reprise_trace", variable}};
  return linkFrame(module, frame, bindings);
}

}  // namespace

Result<DivergentQuads> DivergentQuads::create(const Context& context, Commands& commands, const ShaderProgram& program) {
  DivergentQuads quads(context, commands);
  if (program.analysis.divergence.derivatives.empty()) return quads;
  REPRISE_ASSIGN(const Module tracing, tracingModule(program));
  ShaderProgram traced = program;
  traced.fragment_words = writeModule(tracing);
  traced.interface.outputs = {{"reprise_parted", 0, ScalarKind::kFloat, 4}};
  VariantOptions original;
  original.strategy = "original";
  REPRISE_ASSIGN(quads.package_, buildPackage(traced, {}, original, {}));
  quads.interface_ = std::make_unique<const ShaderInterface>(std::move(traced.interface));
  return quads;
}

Result<std::vector<std::vector<bool>>> DivergentQuads::find(const HarnessOptions& inputs, int frames) {
  std::vector<std::vector<bool>> divergent;
  if (interface_ == nullptr) return divergent;
  REPRISE_ASSIGN(Harness harness, Harness::create(*context_, *commands_, *interface_, inputs));
  if (!player_) {
    REPRISE_ASSIGN(player_, harness.createPlayer(package_, true));
  }
  player_->restart();
  for (int frame = 0; frame < frames; ++frame) {
    REPRISE_ASSIGN(const HarnessFrame played, harness.play(*player_, {frame, 1}));
    std::vector<bool>& pixels = divergent.emplace_back(played.depth.size(), false);
    for (std::size_t pixel = 0; pixel < pixels.size(); ++pixel) pixels[pixel] = played.colors[0][4 * pixel] != 0;
  }
  return divergent;
}

std::string divergenceNote(const ShaderProgram& program, const std::vector<std::vector<bool>>& divergent) {
  const std::vector<DivergenceWarning> warnings = divergenceWarnings(*program.fragment, program.analysis, program.sources);
  if (warnings.empty()) return "";
  std::size_t left_out = 0;
  for (const std::vector<bool>& frame : divergent) left_out = std::max(left_out, static_cast<std::size_t>(std::count(frame.begin(), frame.end(), true)));
  const Place& place = warnings.front().place;
  std::string text = fmt::format("up to {} pixels a frame left out: {}", left_out, warnings.front().message);
  if (place.line > 0) text += fmt::format(" ({}:{})", place.file, place.line);
  if (warnings.size() > 1) text += fmt::format(" and {} more", warnings.size() - 1);
  return text;
}

}  // namespace reprise
