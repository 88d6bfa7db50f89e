#include "compiler/transforms/previous_position.h"

#include <algorithm>
#include <unordered_set>

#include "compiler/ir/globals.h"
#include "compiler/ir/optimize.h"
#include "compiler/transforms/clone_function.h"
#include "compiler/transforms/link_frame.h"
#include "compiler/transforms/redirect_variable.h"

namespace reprise {
namespace {

using spv::Op;
using spv::StorageClass;

constexpr std::uint32_t kDrawBinding = 1;
constexpr std::uint32_t kPushConstantOffset = 16;
constexpr std::uint32_t kFirstPreviousBinding = 16;

Error refused(const std::string& code, const std::string& message) { return {ErrorKind::kRefused, code, message, {}}; }

std::uint32_t pointeeOf(const Module& module, const Instruction& variable) {
  return findGlobal(module, variable.type_id)->word(1);
}

struct PositionOutput {
  std::uint32_t variable = 0;
  std::optional<std::uint32_t> member;  // of a gl_PerVertex block
};

std::optional<PositionOutput> findPosition(const Module& module) {
  const auto position = static_cast<std::uint32_t>(spv::BuiltIn::Position);
  for (const Instruction& global : module.globals) {
    if (global.opcode != Op::OpVariable || static_cast<StorageClass>(global.word(0)) != StorageClass::Output) continue;
    if (decorationOf(module, global.result_id, spv::Decoration::BuiltIn) == position) return PositionOutput{global.result_id, {}};
    const std::uint32_t type_id = pointeeOf(module, global);
    const Instruction* type = findGlobal(module, type_id);
    if (type->opcode != Op::OpTypeStruct) continue;
    for (std::uint32_t member = 0; member < type->operands.size(); ++member)
      if (memberDecorationOf(module, type_id, member, spv::Decoration::BuiltIn) == position)
        return PositionOutput{global.result_id, member};
  }
  return std::nullopt;
}

std::unordered_set<std::uint32_t> idsUsedBy(const Function& function) {
  std::unordered_set<std::uint32_t> used;
  for (const Block& block : function.blocks)
    for (const Instruction& instruction : block.instructions)
      for (const Operand& operand : instruction.operands)
        if (operand.is_id) used.insert(operand.words[0]);
  return used;
}

// The size of a block: the end of its last member, rounded up to 16 bytes as std140 does.
std::uint32_t sizeOf(const Module& module, std::uint32_t type_id);

std::uint32_t memberSize(const Module& module, std::uint32_t struct_id, std::uint32_t member, std::uint32_t type_id) {
  const Instruction* type = findGlobal(module, type_id);
  if (type->opcode == Op::OpTypeMatrix)
    return type->word(1) * memberDecorationOf(module, struct_id, member, spv::Decoration::MatrixStride).value_or(16);
  return sizeOf(module, type_id);
}

std::uint32_t sizeOf(const Module& module, std::uint32_t type_id) {
  const Instruction* type = findGlobal(module, type_id);
  switch (type->opcode) {
    case Op::OpTypeInt:
    case Op::OpTypeFloat: return type->word(0) / 8;
    case Op::OpTypeVector: return type->word(1) * sizeOf(module, type->word(0));
    case Op::OpTypeMatrix: return type->word(1) * 16;
    case Op::OpTypeArray: {
      const Instruction* length = findGlobal(module, type->word(1));
      return length->word(0) * decorationOf(module, type_id, spv::Decoration::ArrayStride).value_or(16);
    }
    case Op::OpTypeStruct: {
      std::uint32_t end = 0;
      for (std::uint32_t member = 0; member < type->operands.size(); ++member)
        end = std::max(end, memberDecorationOf(module, type_id, member, spv::Decoration::Offset).value_or(0) +
                                memberSize(module, type_id, member, type->word(member)));
      return (end + 15) / 16 * 16;
    }
    default: return 0;
  }
}

// A struct { uint valid_last_frame; Push previous; } in a uniform block: the push constants' own struct type is copied,
// since a type that is decorated Block must not be nested.
std::uint32_t addDrawBlock(Module& module, std::uint32_t push_type, std::uint32_t reprise_set) {
  const std::uint32_t copy = module.freshId();
  Instruction type = *findGlobal(module, push_type);
  type.result_id = copy;
  module.globals.push_back(type);
  const std::size_t count = module.annotations.size();
  for (std::size_t i = 0; i < count; ++i) {
    Instruction annotation = module.annotations[i];
    if (annotation.opcode != Op::OpMemberDecorate || annotation.word(0) != push_type) continue;
    annotation.operands[0] = idOperand(copy);
    module.annotations.push_back(std::move(annotation));
  }
  const std::uint32_t block = module.freshId();
  const std::uint32_t flag = uintType(module);
  module.globals.push_back(makeInstruction(Op::OpTypeStruct, 0, block, {idOperand(flag), idOperand(copy)}));
  addDecoration(module, block, spv::Decoration::Block);
  const auto offsetMember = [&](std::uint32_t member, std::uint32_t offset) {
    module.annotations.push_back(makeInstruction(
        Op::OpMemberDecorate, 0, 0, {idOperand(block), literalOperand(member),
                                     literalOperand(static_cast<std::uint32_t>(spv::Decoration::Offset)), literalOperand(offset)}));
  };
  offsetMember(0, 0);
  offsetMember(1, kPushConstantOffset);
  const std::uint32_t variable = addVariable(module, StorageClass::Uniform, block, "reprise_draw_previous");
  addDecoration(module, variable, spv::Decoration::DescriptorSet, {reprise_set});
  addDecoration(module, variable, spv::Decoration::Binding, {kDrawBinding});
  return variable;
}

// The clone's inputs redirected to last frame's copies; appends them to `inputs`.
Result<Module> usePreviousInputs(const Module& module, std::uint32_t clone, std::uint32_t reprise_set,
                                 std::vector<PreviousInput>& inputs) {
  Module result = module;
  const std::unordered_set<std::uint32_t> used = idsUsedBy(*findFunction(module, clone));
  for (const Instruction& global : module.globals) {
    if (global.opcode != Op::OpVariable || used.count(global.result_id) == 0) continue;
    const std::uint32_t id = global.result_id;
    const auto storage = static_cast<StorageClass>(global.word(0));
    const std::uint32_t block = pointeeOf(module, global);
    const std::string of_type = nameOf(module, block), name = of_type.empty() ? nameOf(module, id) : of_type;
    if (storage == StorageClass::PushConstant) {
      const std::uint32_t previous = addDrawBlock(result, block, reprise_set);
      REPRISE_ASSIGN(result, redirectVariable(result, {clone, id, previous, {1}, {}}));
      inputs.push_back({PreviousSource::kPushConstants, name, 0, 0, sizeOf(module, block), 0});
    } else if (storage == StorageClass::Uniform && decorationOf(module, block, spv::Decoration::Block)) {
      const std::uint32_t binding = kFirstPreviousBinding + static_cast<std::uint32_t>(inputs.size());
      const std::uint32_t previous = addVariable(result, storage, block, "reprise_previous_" + name);
      addDecoration(result, previous, spv::Decoration::DescriptorSet, {reprise_set});
      addDecoration(result, previous, spv::Decoration::Binding, {binding});
      REPRISE_ASSIGN(result, redirectVariable(result, {clone, id, previous, {}, {}}));
      inputs.push_back({PreviousSource::kUniformBlock, name,
                        decorationOf(module, id, spv::Decoration::DescriptorSet).value_or(0),
                        decorationOf(module, id, spv::Decoration::Binding).value_or(0), sizeOf(module, block), binding});
    } else if (storage != StorageClass::Input && storage != StorageClass::Output && storage != StorageClass::Private) {
      return refused("vertex.input", "the position depends on '" + nameOf(module, id) +
                                         "', whose content of the last frame is not kept (uniform blocks and push constants are)");
    }
  }
  return result;
}

std::uint32_t locationsOf(const Module& module, std::uint32_t type_id) {
  const Instruction* type = findGlobal(module, type_id);
  switch (type->opcode) {
    case Op::OpTypeMatrix: return type->word(1);
    case Op::OpTypeArray: return findGlobal(module, type->word(1))->word(0) * locationsOf(module, type->word(0));
    case Op::OpTypeStruct: {
      std::uint32_t sum = 0;
      for (std::size_t member = 0; member < type->operands.size(); ++member) sum += locationsOf(module, type->word(member));
      return sum;
    }
    case Op::OpTypeVector: {
      const Instruction* component = findGlobal(module, type->word(0));
      return component->word(0) == 64 && type->word(1) > 2 ? 2 : 1;
    }
    default: return 1;
  }
}

std::uint32_t firstFreeLocation(const Module& module, StorageClass storage) {
  std::uint32_t free = 0;
  for (const Instruction& global : module.globals) {
    if (global.opcode != Op::OpVariable || static_cast<StorageClass>(global.word(0)) != storage) continue;
    const std::uint32_t type_id = pointeeOf(module, global);
    if (const auto location = decorationOf(module, global.result_id, spv::Decoration::Location)) {
      free = std::max(free, *location + locationsOf(module, type_id));
      continue;
    }
    const Instruction* type = findGlobal(module, type_id);
    if (type->opcode != Op::OpTypeStruct) continue;
    for (std::uint32_t member = 0; member < type->operands.size(); ++member)
      if (const auto location = memberDecorationOf(module, type_id, member, spv::Decoration::Location))
        free = std::max(free, *location + locationsOf(module, type->word(member)));
  }
  return free;
}

// On the variable, also where the position is a member of gl_PerVertex: some drivers do not take the decoration on members.
void makePositionInvariant(Module& module, const PositionOutput& position) {
  if (!decorationOf(module, position.variable, spv::Decoration::Invariant))
    addDecoration(module, position.variable, spv::Decoration::Invariant);
}

}  // namespace

std::uint32_t firstFreeVarying(const Module& vertex, const Module& fragment) {
  return std::max(firstFreeLocation(vertex, StorageClass::Output), firstFreeLocation(fragment, StorageClass::Input));
}

Result<PreviousPosition> addPreviousPosition(const Module& vertex, const PreviousPositionOptions& options) {
  REPRISE_CHECK(options.frame != nullptr && vertex.entry_points.size() == 1, vertex.entry_points.size());
  const auto position = findPosition(vertex);
  if (!position) return refused("vertex.no_position", "the vertex shader writes no gl_Position");
  const std::uint32_t current = vertex.entry_points.front().word(1);
  ClonedFunction cloned = cloneFunction(vertex, current);
  Module module = addEntryPoint(cloned.module, cloned.function, "reprise_prior", current);
  const std::uint32_t vec4 = vectorType(module, floatType(module), 4);
  // An output while dead code is removed, so that its stores count; linking makes it the frame's private variable.
  const std::uint32_t slot = addVariable(module, StorageClass::Output, vec4, "reprise_position_slot");
  for (Instruction& entry : module.entry_points) entry.operands.push_back(idOperand(slot));
  REPRISE_ASSIGN(module, redirectVariable(module, {cloned.function, position->variable, slot, {}, position->member}));
  REPRISE_ASSIGN(module, hideOutputs(module, cloned.function, HiddenOutputs::kColors));
  REPRISE_ASSIGN(module, removeDeadCode(module));
  PreviousPosition result;
  REPRISE_ASSIGN(module, usePreviousInputs(module, cloned.function, options.reprise_set, result.inputs));
  makePositionInvariant(module, *position);
  result.module = linkFrame(module, *options.frame,
                            {{{"reprise_current", current}, {"reprise_prior", cloned.function}},
                             {{"reprise_previous_position", slot}}});
  return result;
}

}  // namespace reprise
