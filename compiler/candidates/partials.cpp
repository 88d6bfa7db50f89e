#include "compiler/candidates/partials.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <set>

namespace reprise {
namespace {

using spv::Op;

std::optional<double> constantOf(const Module& module, std::uint32_t id) {
  const Instruction* constant = findGlobal(module, id);
  if (constant == nullptr) return std::nullopt;
  if (constant->opcode == Op::OpConstantComposite) return constantOf(module, constant->word(0));
  const Instruction* type = findGlobal(module, constant->type_id);
  if (constant->opcode != Op::OpConstant || type->opcode != Op::OpTypeFloat || type->word(0) != 32) return std::nullopt;
  return std::abs(static_cast<double>(std::bit_cast<float>(constant->word(0))));
}

class PartialFinder {
 public:
  PartialFinder(const PreparedShader& shader, const ShaderAnalysis& analysis) : module_(shader.module), analysis_(analysis) {}

  void addPartialsOf(const Chain& chain, std::vector<Partial>& partials) const {
    std::set<std::vector<int>> input_sets;
    for (const ChainTerm& term : chain.terms) input_sets.insert(inputsOf(term));
    std::set<std::vector<bool>> seen;
    for (const std::vector<int>& inputs : input_sets) {
      std::vector<bool> kept;
      for (const ChainTerm& term : chain.terms) {
        const std::vector<int> own = inputsOf(term);
        kept.push_back(std::includes(inputs.begin(), inputs.end(), own.begin(), own.end()));
      }
      if (worthSplitting(kept) && seen.insert(kept).second) partials.push_back(partial(chain, kept, false));
    }
    std::vector<bool> all_but_heaviest(chain.terms.size(), true);
    all_but_heaviest[heaviest(chain)] = false;
    if (seen.insert(all_but_heaviest).second) partials.push_back(partial(chain, all_but_heaviest, true));
  }

 private:
  // A single term is a value that stands for itself.
  static bool worthSplitting(const std::vector<bool>& kept) {
    const auto count = std::count(kept.begin(), kept.end(), true);
    return count >= 2 && count < static_cast<std::ptrdiff_t>(kept.size());
  }

  const Node* nodeOf(std::uint32_t value) const {
    const auto found = analysis_.graph.node_of.find(value);
    return found == analysis_.graph.node_of.end() ? nullptr : &analysis_.graph.nodes[static_cast<std::size_t>(found->second)];
  }

  std::vector<int> inputsOf(const ChainTerm& term) const {
    const auto found = analysis_.graph.node_of.find(term.value);
    return found == analysis_.graph.node_of.end() ? std::vector<int>{} : analysis_.inputs_of[static_cast<std::size_t>(found->second)];
  }

  // The constant that a term is multiplied with.
  std::optional<double> factorOf(const ChainTerm& term) const {
    const Node* node = nodeOf(term.value);
    if (node == nullptr) return constantOf(module_, term.value);
    const Instruction& product = *node->instruction;
    if (product.opcode != Op::OpFMul && product.opcode != Op::OpVectorTimesScalar) return std::nullopt;
    const auto left = constantOf(module_, product.word(0));
    return left ? left : constantOf(module_, product.word(1));
  }

  double costOfTerm(const ChainTerm& term) const {
    const auto found = analysis_.graph.node_of.find(term.value);
    return found == analysis_.graph.node_of.end() ? 0 : costOf(analysis_.graph, neededNodes(analysis_.graph, {found->second}));
  }

  // Of a long chain the costs of the terms are not told apart.
  static constexpr std::size_t kMostCosted = 64;

  std::size_t heaviest(const Chain& chain) const {
    std::vector<double> weights;
    for (const ChainTerm& term : chain.terms) {
      const auto factor = chain.kind == ChainKind::kSum ? factorOf(term) : std::nullopt;
      if (!factor) break;
      weights.push_back(*factor);
    }
    if (weights.size() < chain.terms.size()) {
      weights.clear();
      for (const ChainTerm& term : chain.terms) weights.push_back(chain.terms.size() <= kMostCosted ? costOfTerm(term) : 0);
    }
    return static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
  }

  Partial partial(const Chain& chain, const std::vector<bool>& kept, bool all_but_heaviest) const {
    std::set<int> inputs;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (!kept[i]) continue;
      const std::vector<int> own = inputsOf(chain.terms[i]);
      inputs.insert(own.begin(), own.end());
    }
    return {{chain, kept}, {inputs.begin(), inputs.end()}, all_but_heaviest};
  }

  const Module& module_;
  const ShaderAnalysis& analysis_;
};

}  // namespace

std::vector<Partial> findPartials(const PreparedShader& shader, const ShaderAnalysis& analysis) {
  const PartialFinder finder(shader, analysis);
  std::vector<Partial> partials;
  for (const Chain& chain : findChains(shader.module, *findFunction(shader.module, shader.entry_function))) {
    const auto node = analysis.graph.node_of.find(chain.root);
    if (partials.size() >= kMostPartials) break;
    if (node == analysis.graph.node_of.end() || !analysis.live[static_cast<std::size_t>(node->second)]) continue;
    if (analysis.graph.nodes[static_cast<std::size_t>(node->second)].loop_depth == 0) finder.addPartialsOf(chain, partials);
  }
  return partials;
}

}  // namespace reprise
