#include "compiler/strategies/refuse_variant.h"

#include <algorithm>

#include "compiler/strategies/kept_inputs.h"

namespace reprise {
namespace {

Error refused(const char* code, const std::string& why) { return {ErrorKind::kRefused, code, why, {}}; }

bool testsEarly(const ShaderProgram& program) {
  const std::vector<Instruction>& modes = program.fragment->module.execution_modes;
  return std::any_of(modes.begin(), modes.end(), isEarlyTests);
}

std::optional<Error> refuseState(const Strategy& strategy, const ShaderProgram& program, const StateLimits& limits) {
  if (strategy.passes.size() > 1 && testsEarly(program) && decidesDepth(program))
    return refused("state.early_tests", "'" + strategy.name +
                                            "' tells hits from misses by discarding, which early_fragment_tests makes too late for this shader");
  const bool compares_equal = std::any_of(strategy.passes.begin(), strategy.passes.end(),
                                          [](const PassPlan& pass) { return pass.depth == DepthUse::kEqualNoWrite; });
  if (compares_equal && program.interface.writes_depth)
    return refused("state.computed_depth", "'" + strategy.name +
                                               "' needs equal depths in several passes, which drivers need not compute for a shader that writes depth");
  if (strategy.rejects_by_depth && !limits.strict_depth_with_writes)
    return refused("state.depth_compare", "'" + strategy.name + "' tells hits from misses by depth and needs a LESS or GREATER test with writes");
  if (needsRejectedLanes(strategy, program) && !limits.rejected_lanes_load)
    return refused("device.rejected_lanes",
                   "'" + strategy.name + "' rejects a part of a quad, and on " + (limits.device.empty() ? "this device" : "'" + limits.device + "'") +
                       " rejected pixels read nothing from storage buffers, so that the derivatives that this shader takes of such reads would be wrong beside them");
  if (flagsDraws(strategy) && !limits.several_draws)
    return refused("state.one_draw", "'" + strategy.name + "' leaves out objects without misses, and there is only one object");
  if (strategy.needs_stencil && !limits.stencil)
    return refused("state.no_stencil", "'" + strategy.name + "' needs a depth target with stencil");
  return std::nullopt;
}

std::optional<Error> refuseRepair(const Strategy& strategy, const ShaderProgram& program, const StateLimits& limits) {
  if (const Result<KeptInputs> kept = keptInputs(program.fragment->module, false); !kept.ok()) return kept.error();
  if (program.analysis.takes_derivatives)
    return refused("repair.derivatives", "'" + strategy.name +
                                             "' finishes pixels apart from their triangle, where the derivatives that this shader takes are lost");
  if (decidesDepth(program))
    return refused("repair.discards", "'" + strategy.name +
                                          "' draws every fragment at the depth of its triangle before it is shaded; this shader discards or writes depth");
  if (!limits.shared_inputs)
    return refused("state.shared_inputs", "'" + strategy.name +
                                              "' finishes the pixels of all draws at once, but these differ in what the fragment shader reads besides "
                                              "its varyings (uniforms, push constants or textures of each object)");
  return std::nullopt;
}

}  // namespace

bool isEarlyTests(const Instruction& execution_mode) {
  return execution_mode.opcode == spv::Op::OpExecutionMode &&
         static_cast<spv::ExecutionMode>(execution_mode.word(1)) == spv::ExecutionMode::EarlyFragmentTests;
}

bool needsRejectedLanes(const Strategy& strategy, const ShaderProgram& program) {
  return strategy.caches && strategy.selectable && !repairs(strategy) && strategy.passes.size() > 1 && program.analysis.derivatives_read_buffers;
}

bool decidesDepth(const ShaderProgram& program) { return program.analysis.discards || program.interface.writes_depth; }

std::optional<Error> refuseVariant(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options,
                                   const StateLimits& limits) {
  const Strategy& strategy = *findStrategy(options.strategy);
  if (!strategy.caches) return std::nullopt;
  if (program.analysis.refusal) return program.analysis.refusal;
  if (auto refusal = refuseState(strategy, program, limits)) return refusal;
  if (repairs(strategy))
    if (auto refusal = refuseRepair(strategy, program, limits)) return refusal;
  if (isInteger(candidate.scalar) && options.filter != Filter::kNearest)
    return refused("filter.integer", "'" + candidate.id + "' is of type " + candidate.type +
                                         ", which is kept bit by bit and cannot be interpolated; fetch it with the nearest filter");
  return std::nullopt;
}

}  // namespace reprise
