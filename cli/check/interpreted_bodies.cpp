#include "cli/check/interpreted_bodies.h"

#include "compiler/ir/builder.h"
#include "compiler/ir/globals.h"
#include "compiler/strategies/payload_bodies.h"
#include "compiler/transforms/redirect_variable.h"

namespace reprise {
namespace {

using spv::Op;

// The payload is between the bodies and no output.
Result<Module> withPrivatePayload(const PayloadBodies& bodies) {
  const Instruction* slot = findGlobal(bodies.module, bodies.payload_variable);
  if (slot == nullptr) return bodies.module;
  Module module = bodies.module;
  const std::uint32_t pointee = findGlobal(module, slot->type_id)->word(1);
  const std::uint32_t kept = addVariable(module, spv::StorageClass::Private, pointee, "payload");
  for (const std::uint32_t body : {bodies.hit, bodies.miss}) {
    if (body == 0) continue;
    REPRISE_ASSIGN(module, redirectVariable(module, {body, bodies.payload_variable, kept, {}, {}}));
  }
  removeId(module, bodies.payload_variable);
  return module;
}

// One entry point, which calls the body of misses and then that of hits.
Module joined(const Module& bodies, std::uint32_t miss, std::uint32_t hit) {
  Module module = bodies;
  const Instruction like = findFunction(module, miss)->definition;
  Function main;
  main.definition = like;
  main.definition.result_id = module.freshId();
  main.blocks.push_back({module.freshId(), {}});
  Builder build(module, main.blocks.front().instructions);
  build.result(Op::OpFunctionCall, like.type_id, {idOperand(miss)});
  build.result(Op::OpFunctionCall, like.type_id, {idOperand(hit)});
  build.effect(Op::OpReturn, {});
  std::erase_if(module.entry_points, [&](const Instruction& entry) { return entry.word(1) != miss; });
  std::erase_if(module.execution_modes, [&](const Instruction& mode) { return mode.word(0) != miss; });
  module.entry_points.front().operands[1] = idOperand(main.id());
  for (Instruction& mode : module.execution_modes) mode.operands[0] = idOperand(main.id());
  module.functions.push_back(std::move(main));
  return module;
}

Result<std::vector<std::uint32_t>> wordsOf(const PreparedShader& shader, const Candidate& candidate) {
  Bodies wanted;
  wanted.miss = true;
  wanted.hit = !isRegrouped(candidate);
  REPRISE_ASSIGN(const PayloadBodies bodies, makeBodies(shader, candidate.values, wanted));
  REPRISE_ASSIGN(const Module module, withPrivatePayload(bodies));
  return writeModule(wanted.hit ? joined(module, bodies.miss, bodies.hit) : module);
}

}  // namespace

Interpreted interpretBodies(std::span<const std::uint32_t> given, const PreparedShader& shader, const Candidate& candidate) {
  const Result<std::vector<std::uint32_t>> words = wordsOf(shader, candidate);
  if (!words.ok()) return {Computation::kUnknown, words.error().message};
  return interpretPrepared(given, *words);
}

}  // namespace reprise
