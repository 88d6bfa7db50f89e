#include "compiler/strategies/payload_bodies.h"

#include <algorithm>
#include <unordered_set>

#include "compiler/ir/globals.h"
#include "compiler/ir/optimize.h"
#include "compiler/transforms/clone_function.h"
#include "compiler/transforms/payload.h"
#include "compiler/transforms/redirect_variable.h"
#include "compiler/transforms/regroup.h"

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
  for (const std::uint32_t slot : {bodies.wanted_variable, bodies.payload_variable})
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

std::uint32_t translated(const ClonedFunction& cloned, std::uint32_t id) {
  const auto found = cloned.copy_of.find(id);
  return found == cloned.copy_of.end() ? id : found->second;  // constants are shared
}

Regrouping translated(const ClonedFunction& cloned, Regrouping regrouping) {
  regrouping.chain.root = translated(cloned, regrouping.chain.root);
  for (ChainTerm& term : regrouping.chain.terms) term.value = translated(cloned, term.value);
  return regrouping;
}

class BodyMaker {
 public:
  BodyMaker(const PreparedShader& shader, std::span<const CandidateValue> values) : original_(shader.entry_function), values_(values) {
    bodies_.module = shader.module;
  }

  Result<PayloadBodies> run(const Bodies& wanted) {
    addSlots(wanted);
    placeParts();
    if (wanted.hit) REPRISE_TRY(makeHit(wanted.colors));
    if (wanted.wants) REPRISE_TRY(makeWants());
    if (wanted.miss) {
      REPRISE_TRY(makeMiss(wanted.colors));
    } else {
      dropEntryPoint(module(), original_);
    }
    REPRISE_ASSIGN(module(), removeDeadCode(module()));
    locateSlots(bodies_);
    return std::move(bodies_);
  }

 private:
  Module& module() { return bodies_.module; }

  void addSlots(const Bodies& wanted) {
    int channels = 1;
    for (const CandidateValue& value : values_)
      channels = std::max({channels, value.first_channel + value.channels, value.guard_channel + 1});
    const std::uint32_t type = values_.empty() ? floatType(module()) : resultTypes(module()).at(values_.front().value);
    const std::uint32_t array = payloadArrayType(module(), type, static_cast<std::uint32_t>(channels + 3) / 4);
    bodies_.payload_variable = addSlot(module(), array, "reprise_payload_slot");
    if (wanted.wants) bodies_.wanted_variable = addSlot(module(), uintType(module()), "reprise_wanted_slot");
  }

  // Values that the shader does not compute as they are kept get an id, in code that is dead but for the exports.
  void placeParts() {
    place_ = {original_, bodies_.payload_variable, {}};
    for (const CandidateValue& value : values_) {
      PayloadPart part{value.value, value.first_channel, value.guard_channel};
      if (value.regrouping) {
        part.value = module().freshId();
        module() = addPartial(module(), {original_, part.value}, *value.regrouping);
      }
      place_.parts.push_back(part);
    }
  }

  ClonedFunction cloneOriginal(const char* name) {
    ClonedFunction cloned = cloneFunction(module(), original_);
    module() = addEntryPoint(cloned.module, cloned.function, name, original_);
    return cloned;
  }

  PayloadPlace placeIn(const ClonedFunction& cloned) const {
    PayloadPlace place = place_;
    place.function = cloned.function;
    for (PayloadPart& part : place.parts) part.value = translated(cloned, part.value);
    return place;
  }

  Result<void> hide(std::uint32_t function) {
    REPRISE_ASSIGN(module(), hideOutputs(module(), function, HiddenOutputs::kColors));
    return {};
  }

  Result<void> makeHit(bool colors) {
    REPRISE_CHECK(!values_.empty(), original_);
    const ClonedFunction cloned = cloneOriginal("reprise_hit_body");
    bodies_.hit = cloned.function;
    const PayloadPlace place = placeIn(cloned);
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (values_[i].regrouping)
        module() = usePartial(module(), {cloned.function, place.parts[i].value}, translated(cloned, *values_[i].regrouping));
    module() = substitutePayload(module(), place);
    return colors ? Result<void>{} : hide(cloned.function);
  }

  Result<void> makeWants() {
    const ClonedFunction cloned = cloneOriginal("reprise_wants_body");
    bodies_.wants = cloned.function;
    module() = exportWanted(module(), placeIn(cloned), bodies_.wanted_variable);
    REPRISE_ASSIGN(module(), hideOutputs(module(), cloned.function, HiddenOutputs::kAll, bodies_.wanted_variable));
    return {};
  }

  Result<void> makeMiss(bool colors) {
    bodies_.miss = original_;
    module() = exportPayload(module(), place_);
    return colors ? Result<void>{} : hide(original_);
  }

  std::uint32_t original_;
  std::span<const CandidateValue> values_;
  PayloadBodies bodies_;
  PayloadPlace place_;
};

}  // namespace

Result<PayloadBodies> makeBodies(const PreparedShader& shader, std::span<const CandidateValue> values, const Bodies& wanted) {
  return BodyMaker(shader, values).run(wanted);
}

}  // namespace reprise

