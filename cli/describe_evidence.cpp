#include "cli/describe_evidence.h"

#include <map>

#include "cli/describe_run.h"
#include "compiler/analysis/line_costs.h"

namespace reprise {
namespace {

// Instructions to lines of the sources that are shown.
class LineFinder {
 public:
  LineFinder(const PreparedShader& shader, const std::vector<EvidenceSource>& sources) {
    for (const Instruction& name : shader.module.debug_sources) {
      if (name.opcode != spv::Op::OpString) continue;
      for (std::size_t i = 0; i < sources.size(); ++i)
        if (sources[i].path == stringOf(name.operands[0])) source_of_[name.result_id] = i;
    }
  }

  std::optional<EvidenceLine> find(const Instruction& instruction) const {
    const auto source = source_of_.find(instruction.line.file);
    if (source == source_of_.end() || instruction.line.line == 0) return std::nullopt;
    return EvidenceLine{source->second, static_cast<int>(instruction.line.line)};
  }

 private:
  std::map<std::uint32_t, std::size_t> source_of_;
};

// What a hit reads from the cache: the values, or of a regrouped chain its kept terms.
std::vector<int> payloadNodes(const ValueGraph& graph, const Candidate& candidate) {
  std::vector<int> nodes;
  const auto add = [&](std::uint32_t value) {
    if (const auto node = graph.node_of.find(value); node != graph.node_of.end()) nodes.push_back(node->second);
  };
  for (const CandidateValue& value : candidate.values) {
    if (!value.regrouping) {
      nodes.push_back(value.node);
      continue;
    }
    for (std::size_t term = 0; term < value.regrouping->kept.size(); ++term)
      if (value.regrouping->kept[term]) add(value.regrouping->chain.terms[term].value);
  }
  return nodes;
}

EvidenceSlice cutAt(const ShaderAnalysis& analysis, const LineFinder& finder, const Candidate& candidate) {
  const std::vector<int> payload = payloadNodes(analysis.graph, candidate);
  const std::vector<bool> in_slice = neededNodes(analysis.graph, payload), in_tail = neededNodes(analysis.graph, {}, payload);
  struct Use {
    bool slice = false, tail = false;
  };
  std::map<EvidenceLine, Use> uses;
  for (std::size_t node = 0; node < analysis.graph.nodes.size(); ++node) {
    const Node& one = analysis.graph.nodes[node];
    if (!analysis.live[node] || !(one.cost > 0)) continue;
    const std::optional<EvidenceLine> line = finder.find(*one.instruction);
    if (!line) continue;
    if (in_slice[node]) uses[*line].slice = true;
    if (in_tail[node]) uses[*line].tail = true;
  }
  EvidenceSlice cut{candidate.id, {}, {}, {}};
  for (const auto& [line, use] : uses) {
    if (!use.slice && !use.tail) continue;
    (use.slice && use.tail ? cut.both : use.slice ? cut.slice : cut.tail).push_back(line);
  }
  return cut;
}

}  // namespace

std::vector<EvidenceSource> describeSources(const ShaderProgram& program) {
  std::map<std::string, std::map<int, double>> shares;
  for (const auto& [place, share] : lineCosts(*program.fragment, program.analysis)) shares[place.first][place.second] = share;
  std::vector<EvidenceSource> described;
  for (const SourceFile& source : program.sources) {
    const auto lines = shares.find(source.path);
    if (lines == shares.end()) continue;
    EvidenceSource one{source.path, source.text, std::vector<double>(static_cast<std::size_t>(lines->second.rbegin()->first), 0.0)};
    for (const auto& [line, share] : lines->second)
      if (line > 0) one.line_shares[static_cast<std::size_t>(line) - 1] = share;
    described.push_back(std::move(one));
  }
  return described;
}

std::vector<EvidenceSlice> describeSlices(const ShaderProgram& program, const std::vector<Candidate>& candidates,
                                          const std::vector<EvidenceSource>& sources) {
  const LineFinder finder(*program.fragment, sources);
  std::vector<EvidenceSlice> slices;
  for (const Candidate& candidate : candidates)
    if (candidate.kept()) slices.push_back(cutAt(program.analysis, finder, candidate));
  return slices;
}

std::vector<EvidenceCost> describeCosts(const Training& training, const FittedTraining& fitted) {
  std::vector<EvidenceCost> described;
  for (std::size_t i = 0; i < fitted.cost_study.size(); ++i) {
    const CostStudy& costs = training.costs[fitted.cost_study[i]];
    EvidenceCost one{describeVariant(fitted.input.configurations[i], 1), {}};
    for (const TimedCount& frame : timedAndCounted(training.errors[costs.error_study], costs))
      one.samples.push_back({frame.period_frames, frame.point.hits, frame.point.misses, frame.point.frame_time_ms});
    described.push_back(std::move(one));
  }
  return described;
}

}  // namespace reprise
