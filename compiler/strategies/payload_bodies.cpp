#include "compiler/strategies/payload_bodies.h"

#include <algorithm>
#include <unordered_set>

#include "compiler/ir/globals.h"
#include "compiler/ir/optimize.h"
#include "compiler/transforms/clone_function.h"
#include "compiler/transforms/payload.h"
#include "compiler/transforms/redirect_variable.h"

namespace reprise {
namespace {

// Outputs while dead code is removed, so that stores to them count; linking makes them the frame's private variables.
std::uint32_t addSlot(Module& module, std::uint32_t type, const std::string& name) {
  const std::uint32_t slot = addVariable(module, spv::StorageClass::Output, type, name);
  for (Instruction& entry : module.entry_points) entry.operands.push_back(idOperand(slot));
  return slot;
}

// Locations behind all others, given last: hiding colours goes by locations. They make the module valid as it stands.
void locateSlots(PayloadBodies& bodies) {
  std::uint32_t location = 0;
  for (const Instruction& annotation : bodies.module.annotations)
    if (annotation.opcode == spv::Op::OpDecorate && annotation.word(1) == static_cast<std::uint32_t>(spv::Decoration::Location))
      location = std::max(location, annotation.word(2) + 1);
  for (const std::uint32_t slot : {bodies.payload_variable, bodies.valid_variable})
    if (findGlobal(bodies.module, slot) != nullptr) addDecoration(bodies.module, slot, spv::Decoration::Location, {location++});
}

void dropEntryPoint(Module& module, std::uint32_t function) {
  std::erase_if(module.entry_points, [&](const Instruction& entry) { return entry.word(1) == function; });
  std::erase_if(module.execution_modes, [&](const Instruction& mode) { return mode.word(0) == function; });
  std::unordered_set<std::uint32_t> gone{function};
  const Function& dropped = *findFunction(module, function);
  for (const Instruction& parameter : dropped.parameters) gone.insert(parameter.result_id);
  for (const Block& block : dropped.blocks) {
    gone.insert(block.label);
    for (const Instruction& instruction : block.instructions) gone.insert(instruction.result_id);
  }
  gone.erase(0);
  const auto about = [&](const Instruction& instruction) {
    return !instruction.operands.empty() && instruction.operands[0].is_id && gone.count(instruction.word(0)) != 0;
  };
  std::erase_if(module.names, about);
  std::erase_if(module.annotations, about);
  std::erase_if(module.functions, [&](const Function& one) { return one.id() == function; });
}

}  // namespace

Result<PayloadBodies> makeBodies(const PreparedShader& shader, std::uint32_t value, const Bodies& wanted) {
  PayloadBodies bodies;
  bodies.module = shader.module;
  Module& module = bodies.module;
  const std::uint32_t value_type = value != 0 ? resultTypes(module).at(value) : floatType(module);
  bodies.payload_variable = addSlot(module, payloadVectorType(module, value_type), "reprise_payload_slot");
  bodies.valid_variable = addSlot(module, uintType(module), "reprise_valid_slot");
  const std::uint32_t original = shader.entry_function;
  if (wanted.hit) {
    ClonedFunction cloned = cloneFunction(module, original);
    bodies.hit = cloned.function;
    module = addEntryPoint(cloned.module, cloned.function, "reprise_hit_body", original);
    REPRISE_CHECK(cloned.copy_of.count(value) != 0, value);
    module = substitutePayload(module, {bodies.hit, cloned.copy_of[value], bodies.payload_variable, bodies.valid_variable});
    if (!wanted.colors) {
      REPRISE_ASSIGN(module, hideColorOutputs(module, bodies.hit));
    }
  }
  if (wanted.miss) {
    bodies.miss = original;
    if (value != 0) module = exportPayload(module, {original, value, bodies.payload_variable, bodies.valid_variable});
    if (!wanted.colors) {
      REPRISE_ASSIGN(module, hideColorOutputs(module, original));
    }
  } else {
    dropEntryPoint(module, original);
  }
  REPRISE_ASSIGN(module, removeDeadCode(module));
  locateSlots(bodies);
  return bodies;
}

}  // namespace reprise
