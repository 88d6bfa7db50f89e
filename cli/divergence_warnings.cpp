#include "cli/divergence_warnings.h"

#include <algorithm>

namespace reprise {
namespace {

bool isDerivative(spv::Op opcode) { return opcode >= spv::Op::OpDPdx && opcode <= spv::Op::OpFwidthCoarse; }

}  // namespace

std::vector<DivergenceWarning> divergenceWarnings(const PreparedShader& shader, const ShaderAnalysis& analysis, const std::vector<SourceFile>& sources) {
  std::vector<DivergenceWarning> warnings;
  for (const int node : analysis.divergence.derivatives) {
    const Instruction& instruction = *analysis.graph.nodes[static_cast<std::size_t>(node)].instruction;
    const Place place = placeOf(shader, instruction, sources);
    if (std::any_of(warnings.begin(), warnings.end(), [&](const DivergenceWarning& one) { return one.place == place; })) continue;
    warnings.push_back({place, std::string(isDerivative(instruction.opcode) ? "a derivative" : "a sample with implicit level of detail") +
                                   " stands where pixels of one quad may take different ways, and is undefined there"});
  }
  return warnings;
}

}  // namespace reprise
