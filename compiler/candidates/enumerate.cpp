#include "compiler/candidates/enumerate.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <spirv-tools/libspirv.h>

#include "compiler/analysis/operation_cost.h"
#include "compiler/analysis/places.h"
#include "compiler/candidates/groups.h"
#include "compiler/candidates/partials.h"
#include "compiler/candidates/prune.h"
#include "compiler/candidates/weigh.h"

namespace reprise {
namespace {

using spv::Op;

std::string operationName(const Instruction& instruction) {
  const char* name = spvOpcodeString(static_cast<std::uint32_t>(instruction.opcode));
  return name == nullptr ? "operation" : name;
}

bool dependsOnPixel(const Candidate& candidate, const ShaderAnalysis& analysis) {
  return std::any_of(candidate.inputs.begin(), candidate.inputs.end(), [&](int input) {
    const InputKind kind = analysis.inputs[static_cast<std::size_t>(input)].kind;
    return kind == InputKind::kVarying || kind == InputKind::kBuiltIn;
  });
}

struct Surroundings {
  const PreparedShader& shader;
  const ShaderAnalysis& analysis;
  const PlaceFinder& places;
  const Function& function;
};

DropReason firstReason(const Candidate& candidate, const Surroundings& around) {
  const Node& node = around.analysis.graph.nodes[static_cast<std::size_t>(candidate.values.front().node)];
  if (candidate.channels == 0)
    return {"type.unsupported", "only 16- and 32-bit floats, 32-bit integers, booleans and vectors of them can be kept"};
  if (node.loop_depth > 0)
    return {"place.loop", "it is computed inside a loop, so one pixel has many of it"};
  if (!dependsOnPixel(candidate, around.analysis))
    return {"value.uniform", "it is the same for all pixels"};
  if (onlyRearranges(node.instruction->opcode) || node.instruction->opcode == Op::OpLoad)
    return {"value.rearranged", "it only loads or rearranges other values"};
  if (around.analysis.decides_coverage[static_cast<std::size_t>(candidate.values.front().node)])
    return {"value.coverage", "which pixels are discarded, or their depth, depends on it, and has to be exact in every frame"};
  return {};
}

CandidateValue valueAt(std::size_t node_index, const Surroundings& around) {
  const Node& node = around.analysis.graph.nodes[node_index];
  CandidateValue value;
  value.value = node.instruction->result_id;
  value.node = static_cast<int>(node_index);
  const auto named = around.shader.named.find(value.value);
  if (named != around.shader.named.end()) value.name = named->second.name;
  value.operation = operationName(*node.instruction);
  const PayloadType type = payloadType(around.shader.module, node.instruction->type_id);
  value.channels = type.channels;
  value.scalar = type.scalar;
  value.type = type.channels > 0 ? nameOf(type) : "other";
  value.place = around.places.placeOf(*node.instruction);
  return value;
}

// Gives the values their channels, and those in conditional code their guards: one for each block.
void assignChannels(Candidate& candidate, const Surroundings& around) {
  int next = 0;
  for (CandidateValue& value : candidate.values) {
    value.first_channel = next;
    next += value.channels;
  }
  std::map<int, int> guard_of_block;
  for (CandidateValue& value : candidate.values) {
    const int block = around.analysis.graph.nodes[static_cast<std::size_t>(value.node)].block;
    if (value.channels == 0 || isAlwaysRun(around.analysis.graph.flow, around.function, block)) continue;
    const auto [guard, added] = guard_of_block.emplace(block, next);
    if (added) ++next;
    value.guard_channel = guard->second;
    candidate.conditional = true;
  }
  candidate.channels = next;
}

std::string shortName(const CandidateValue& value) { return value.name.empty() ? value.operation : value.name; }

std::string idOf(const CandidateValue& value) {
  return shortName(value) + "@" + std::filesystem::path(value.place.file).filename().string() + ":" + std::to_string(value.place.line);
}

Candidate singleOf(CandidateValue value) {
  Candidate candidate;
  candidate.id = idOf(value);
  candidate.name = value.name;
  candidate.operation = value.operation;
  candidate.type = value.type;
  candidate.scalar = value.scalar;
  candidate.channels = value.channels;
  candidate.place = value.place;
  candidate.values.push_back(std::move(value));
  return candidate;
}

void takeWeight(Candidate& candidate, const WeighedPayload& weighed, const ShaderAnalysis& analysis) {
  candidate.saved_cost = weighed.saved_cost;
  candidate.share = analysis.total_cost > 0 ? candidate.saved_cost / analysis.total_cost : 0;
  candidate.slice_cost = weighed.slice_cost;
  candidate.slice_takes_derivatives = weighed.slice_takes_derivatives;
  if (weighed.tail_takes_derivatives)
    candidate.dropped = {"tail.derivative",
                         "the rest of the shader takes derivatives of what depends on it, and a neighbouring pixel's payload "
                         "may belong to another surface"};
}

void weigh(Candidate& candidate, const Surroundings& around) {
  takeWeight(candidate, weighPayload(around.analysis, candidate.values), around.analysis);
}

// Weighing a value visits the whole shader. Of more than `most` values that may be candidates those with names are kept, then
// the others at even distances in program order, so that every part of the shader has its candidates.
void dropBeyond(std::size_t most, std::vector<Candidate>& candidates) {
  for (const bool named : {true, false}) {
    const auto isOfKind = [&](const Candidate& candidate) { return candidate.kept() && candidate.name.empty() != named; };
    const auto count = static_cast<std::size_t>(std::count_if(candidates.begin(), candidates.end(), isOfKind));
    const std::size_t allowed = std::min(most, count);
    std::size_t index = 0;
    for (Candidate& candidate : candidates) {
      if (!isOfKind(candidate)) continue;
      if ((index + 1) * allowed / count == index * allowed / count)
        candidate.dropped = {"pruned.many", "the shader has more than " + std::to_string(kMostWeighed) +
                                                " values that could be kept; this one was passed over"};
      ++index;
    }
    most -= allowed;
  }
}

std::vector<Candidate> singleCandidates(const Surroundings& around) {
  const ShaderAnalysis& analysis = around.analysis;
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < analysis.graph.nodes.size(); ++i) {
    const Instruction& instruction = *analysis.graph.nodes[i].instruction;
    if (!analysis.live[i] || instruction.type_id == 0 || instruction.opcode == Op::OpVariable ||
        instruction.opcode == Op::OpAccessChain || instruction.opcode == Op::OpInBoundsAccessChain)
      continue;
    Candidate candidate = singleOf(valueAt(i, around));
    candidate.inputs = analysis.inputs_of[i];
    candidate.dropped = firstReason(candidate, around);
    if (candidate.kept() && analysis.refusal) candidate.dropped = {analysis.refusal->code, analysis.refusal->message};
    candidates.push_back(std::move(candidate));
  }
  dropBeyond(kMostWeighed, candidates);
  const NeedDominators dominators(analysis.graph);
  for (Candidate& candidate : candidates) {
    if (!candidate.kept()) continue;
    assignChannels(candidate, around);
    takeWeight(candidate, weighSingle(analysis, dominators, candidate.values.front()), analysis);
  }
  return candidates;
}

// Parts of chains. Of those that leave out the heaviest term, which save less than the whole and are worth it for their smaller
// error, only the first few by saved cost.
std::vector<Candidate> partialCandidates(const Surroundings& around, std::size_t most_without_heaviest) {
  constexpr std::size_t kMostTermsNamed = 64;
  std::vector<Candidate> candidates, without_heaviest;
  for (Partial& partial : findPartials(around.shader, around.analysis)) {
    const int node = around.analysis.graph.node_of.at(partial.regrouping.chain.root);
    CandidateValue value = valueAt(static_cast<std::size_t>(node), around);
    const auto& kept = partial.regrouping.kept;
    // The 0 that a sum begins with is no term to people.
    int count = 0, all = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const bool computed = around.analysis.graph.node_of.count(partial.regrouping.chain.terms[i].value) != 0;
      all += computed;
      count += computed && kept[i];
    }
    const std::string part = fmt::format("{} of the {} terms of {}", count, all,
                                         value.name.empty() ? "a " + std::string(nameOf(partial.regrouping.chain.kind)) : value.name);
    std::string terms;
    for (std::size_t i = 0; i < kept.size() && i < kMostTermsNamed; ++i) terms += kept[i] ? '1' : '0';
    value.regrouping = std::move(partial.regrouping);
    Candidate candidate = singleOf(std::move(value));
    candidate.id = fmt::format("{}[{}]", candidate.id, terms);
    candidate.name = candidate.values.front().name = part;
    candidate.operation = nameOf(candidate.values.front().regrouping->chain.kind);
    candidate.inputs = std::move(partial.inputs);
    candidate.dropped = firstReason(candidate, around);
    if (!candidate.kept()) continue;
    assignChannels(candidate, around);
    weigh(candidate, around);
    (partial.all_but_heaviest ? without_heaviest : candidates).push_back(std::move(candidate));
  }
  std::stable_sort(without_heaviest.begin(), without_heaviest.end(),
                   [](const Candidate& a, const Candidate& b) { return a.saved_cost > b.saved_cost; });
  for (std::size_t i = 0; i < without_heaviest.size(); ++i) {
    without_heaviest[i].steadier_part = i < most_without_heaviest;
    candidates.push_back(std::move(without_heaviest[i]));
  }
  return candidates;
}

std::string joined(const std::vector<CandidateValue>& values, std::string (*text)(const CandidateValue&)) {
  std::string all;
  for (const CandidateValue& value : values) all += (all.empty() ? "" : " + ") + text(value);
  return all;
}

std::vector<Candidate> groupCandidates(const Surroundings& around, const std::vector<Candidate>& singles, const GroupOptions& options) {
  std::vector<Candidate> candidates;
  for (const std::vector<std::size_t>& group : findGroups(around.analysis, singles, options)) {
    Candidate candidate;
    std::set<int> inputs;
    for (const std::size_t single : group) {
      candidate.values.push_back(singles[single].values.front());
      candidate.values.back().guard_channel = kNoGuard;
      inputs.insert(singles[single].inputs.begin(), singles[single].inputs.end());
    }
    candidate.inputs.assign(inputs.begin(), inputs.end());
    candidate.id = joined(candidate.values, idOf);
    candidate.name = joined(candidate.values, shortName);
    candidate.type = joined(candidate.values, [](const CandidateValue& value) { return value.type; });
    candidate.operation = "group";
    candidate.scalar = candidate.values.front().scalar;
    candidate.place = candidate.values.front().place;
    assignChannels(candidate, around);
    if (candidate.channels > options.most_channels) continue;
    weigh(candidate, around);
    if (candidate.kept()) candidates.push_back(std::move(candidate));
  }
  return candidates;
}

// The application's targets, the cache's and, for training, two for counting share the device's colour targets; a depth beside
// full targets takes one more.
int channelBudget(const PreparedShader& shader) {
  const Module& module = shader.module;
  std::size_t outputs = 0;
  for (const Instruction& global : module.globals)
    outputs += global.opcode == Op::OpVariable && static_cast<spv::StorageClass>(global.word(0)) == spv::StorageClass::Output &&
               decorationOf(module, global.result_id, spv::Decoration::Location).has_value();
  constexpr std::size_t kCountingTargets = 2, kDepthTarget = 1;
  const std::size_t taken = outputs + kCountingTargets + kDepthTarget;
  return taken >= kMostColorTargets ? 4 : static_cast<int>(4 * std::min(kMostPayloadTargets, kMostColorTargets - taken));
}

// Ids must tell candidates apart: the second of a kind on one line gets "#2".
void makeIdsUnique(std::vector<Candidate>& candidates) {
  std::unordered_map<std::string, int> seen;
  for (Candidate& candidate : candidates)
    if (const int count = ++seen[candidate.id]; count > 1) candidate.id += "#" + std::to_string(count);
}

}  // namespace

std::vector<Candidate> enumerateCandidates(const PreparedShader& shader, const ShaderAnalysis& analysis,
                                           const std::vector<SourceFile>& sources, const CandidateOptions& options) {
  const PlaceFinder places(shader, sources);
  const Surroundings around{shader, analysis, places, *findFunction(shader.module, shader.entry_function)};
  std::vector<Candidate> candidates = singleCandidates(around);
  if (!analysis.refusal) {
    GroupOptions grouping;
    grouping.most_channels = channelBudget(shader);
    std::vector<Candidate> groups = groupCandidates(around, candidates, grouping);
    std::vector<Candidate> partials = partialCandidates(around, options.most_without_heaviest);
    for (std::vector<Candidate>* more : {&groups, &partials})
      candidates.insert(candidates.end(), std::make_move_iterator(more->begin()), std::make_move_iterator(more->end()));
  }
  makeIdsUnique(candidates);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.saved_cost > b.saved_cost; });
  pruneCandidates(candidates, analysis.total_cost, options);
  std::stable_partition(candidates.begin(), candidates.end(), [](const Candidate& candidate) { return candidate.kept(); });
  return candidates;
}

namespace {

// What the kept value changes with: of a part of a chain, what its kept terms do.
std::vector<int> inputsOf(const WantedValue& wanted, const ShaderAnalysis& analysis) {
  if (!wanted.regrouping) return analysis.inputs_of[static_cast<std::size_t>(wanted.node)];
  std::set<int> inputs;
  for (std::size_t i = 0; i < wanted.regrouping->kept.size(); ++i) {
    const auto node = analysis.graph.node_of.find(wanted.regrouping->chain.terms[i].value);
    if (!wanted.regrouping->kept[i] || node == analysis.graph.node_of.end()) continue;
    const std::vector<int>& of_term = analysis.inputs_of[static_cast<std::size_t>(node->second)];
    inputs.insert(of_term.begin(), of_term.end());
  }
  return {inputs.begin(), inputs.end()};
}

}  // namespace

Candidate candidateOf(const PreparedShader& shader, const ShaderAnalysis& analysis, const std::vector<SourceFile>& sources,
                      const std::vector<WantedValue>& wanted) {
  const PlaceFinder places(shader, sources);
  const Surroundings around{shader, analysis, places, *findFunction(shader.module, shader.entry_function)};
  Candidate candidate;
  std::set<int> inputs;
  for (const WantedValue& one : wanted) {
    CandidateValue value = valueAt(static_cast<std::size_t>(one.node), around);
    value.regrouping = one.regrouping;
    Candidate single = singleOf(value);
    single.inputs = inputsOf(one, analysis);
    if (candidate.kept()) candidate.dropped = firstReason(single, around);
    inputs.insert(single.inputs.begin(), single.inputs.end());
    candidate.values.push_back(std::move(value));
  }
  candidate.inputs.assign(inputs.begin(), inputs.end());
  candidate.name = joined(candidate.values, shortName);
  candidate.type = joined(candidate.values, [](const CandidateValue& value) { return value.type; });
  candidate.operation = candidate.values.size() > 1 ? "group" : candidate.values.front().operation;
  candidate.scalar = candidate.values.front().scalar;
  candidate.place = candidate.values.front().place;
  if (candidate.kept() && analysis.refusal) candidate.dropped = {analysis.refusal->code, analysis.refusal->message};
  if (!candidate.kept()) return candidate;
  assignChannels(candidate, around);
  weigh(candidate, around);
  return candidate;
}

bool isRegrouped(const Candidate& candidate) {
  return std::any_of(candidate.values.begin(), candidate.values.end(), [](const CandidateValue& value) { return value.regrouping.has_value(); });
}

std::vector<std::string> inputNames(const Candidate& candidate, const ShaderAnalysis& analysis) {
  std::vector<std::string> names;
  for (const int input : candidate.inputs) {
    const InputSource& source = analysis.inputs[static_cast<std::size_t>(input)];
    names.push_back(std::string(nameOf(source.kind)) + " " + source.name);
  }
  return names;
}

}  // namespace reprise
