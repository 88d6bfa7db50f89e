#include "cli/check/neighbour_dependence.h"

#include <algorithm>

#include "cli/check/frame_laws.h"
#include "compiler/ir/builder.h"
#include "compiler/ir/globals.h"

namespace reprise {
namespace {

using spv::Op;

constexpr double kVisible = 1e-5;

std::uint32_t fragCoord(Module& module) {
  for (const Instruction& global : module.globals)
    if (global.opcode == Op::OpVariable && decorationOf(module, global.result_id, spv::Decoration::BuiltIn) == static_cast<std::uint32_t>(spv::BuiltIn::FragCoord))
      return global.result_id;
  const std::uint32_t id = addVariable(module, spv::StorageClass::Input, vectorType(module, floatType(module), 4), "frag_coord");
  addDecoration(module, id, spv::Decoration::BuiltIn, {static_cast<std::uint32_t>(spv::BuiltIn::FragCoord)});
  module.entry_points.front().operands.push_back(idOperand(id));
  return id;
}

// Whether the quad is of this parity.
std::uint32_t condition(Module& module, Builder& build, std::uint32_t parity) {
  const std::uint32_t uint = uintType(module), real = floatType(module), one = uintConstant(module, 1);
  const std::uint32_t place = build.load(vectorType(module, real, 4), fragCoord(module));
  std::uint32_t quads[2];
  for (std::uint32_t axis = 0; axis < 2; ++axis) {
    const std::uint32_t index[] = {axis};
    const std::uint32_t pixel = build.result(Op::OpConvertFToU, uint, {idOperand(build.extract(real, place, index))});
    quads[axis] = build.result(Op::OpShiftRightLogical, uint, {idOperand(pixel), idOperand(one)});
  }
  const std::uint32_t sum = build.result(Op::OpIAdd, uint, {idOperand(quads[0]), idOperand(quads[1])});
  const std::uint32_t bit = build.result(Op::OpBitwiseAnd, uint, {idOperand(sum), idOperand(one)});
  const std::uint32_t boolean = findOrAddGlobal(module, Op::OpTypeBool, 0, {});
  return build.result(Op::OpIEqual, boolean, {idOperand(bit), idOperand(uintConstant(module, parity))});
}

bool runs(std::size_t pixel, std::uint32_t parity) {
  const std::size_t width = HarnessOptions{}.width;
  return ((pixel % width / 2 + pixel / width / 2) & 1) == parity;
}

}  // namespace

Module inEveryOtherQuad(const Module& given, std::uint32_t parity) {
  Module module = given;
  const std::uint32_t original = module.entry_points.front().word(1);
  Function main;
  main.definition = findFunction(module, original)->definition;
  main.definition.result_id = module.freshId();
  const std::uint32_t run = module.freshId(), end = module.freshId();
  main.blocks = {{module.freshId(), {}}, {run, {}}, {end, {}}};
  Builder first(module, main.blocks[0].instructions), call(module, main.blocks[1].instructions), last(module, main.blocks[2].instructions);
  const std::uint32_t chosen = condition(module, first, parity);
  first.mergeAt(end);
  first.branchIf(chosen, run, end);
  call.result(Op::OpFunctionCall, main.definition.type_id, {idOperand(original)});
  call.branch(end);
  last.effect(Op::OpReturn, {});
  module.entry_points.front().operands[1] = idOperand(main.id());
  for (Instruction& mode : module.execution_modes)
    if (mode.word(0) == original) mode.operands[0] = idOperand(main.id());
  module.functions.push_back(std::move(main));
  return module;
}

Result<bool> dependsOnNeighbours(const Module& module, const std::vector<HarnessFrame>& given, const PlayWords& play) {
  for (const std::uint32_t parity : {0u, 1u}) {
    REPRISE_ASSIGN(const std::vector<HarnessFrame> half, play(writeModule(inEveryOtherQuad(module, parity))));
    for (std::size_t frame = 0; frame < std::min(given.size(), half.size()); ++frame) {
      std::vector<bool> left_out(given[frame].depth.size());
      for (std::size_t pixel = 0; pixel < left_out.size(); ++pixel) left_out[pixel] = !runs(pixel, parity) || !covered(given[frame], pixel);
      if (!sameColors(given[frame], half[frame], kVisible, &left_out)) return true;
    }
  }
  return false;
}

}  // namespace reprise
