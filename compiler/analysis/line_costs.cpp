#include "compiler/analysis/line_costs.h"

namespace reprise {

std::map<std::pair<std::string, int>, double> lineCosts(const PreparedShader& shader, const ShaderAnalysis& analysis) {
  std::map<std::uint32_t, std::string> files;
  for (const Instruction& source : shader.module.debug_sources)
    if (source.opcode == spv::Op::OpString) files[source.result_id] = stringOf(source.operands[0]);
  std::map<std::pair<std::string, int>, double> shares;
  if (!(analysis.total_cost > 0)) return shares;
  for (std::size_t node = 0; node < analysis.graph.nodes.size(); ++node) {
    const Node& one = analysis.graph.nodes[node];
    if (!analysis.live[node] || !(one.cost > 0)) continue;
    const LineMark& line = one.instruction->line;
    const auto file = files.find(line.file);
    const bool known = file != files.end() && line.line > 0;
    shares[{known ? file->second : "", known ? static_cast<int>(line.line) : 0}] += one.cost / analysis.total_cost;
  }
  return shares;
}

}  // namespace reprise
