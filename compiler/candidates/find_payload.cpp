#include "compiler/candidates/find_payload.h"

#include <spirv-tools/libspirv.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "compiler/analysis/places.h"
#include "compiler/candidates/slice_changes.h"
#include "compiler/candidates/slice_text.h"
#include "compiler/candidates/value_hashes.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

constexpr std::size_t kMostToldEdits = 4;
constexpr double kMostEdited = 0.5;  // of what still counts as the same value under another name
constexpr int kMostCompared = 64;

// The nodes whose structure is the value's: one, or the kept terms of a chain.
struct Terms {
  std::vector<int> nodes;
  std::vector<bool> negative;
};

Terms termsOf(const CandidateValue& value, const ValueGraph& graph) {
  if (!value.regrouping) return {{value.node}, {false}};
  Terms terms;
  for (std::size_t i = 0; i < value.regrouping->kept.size(); ++i) {
    if (!value.regrouping->kept[i]) continue;
    const ChainTerm& term = value.regrouping->chain.terms[i];
    const auto node = graph.node_of.find(term.value);
    terms.nodes.push_back(node == graph.node_of.end() ? kNoNode : node->second);
    terms.negative.push_back(term.negative);
  }
  return terms;
}

std::vector<std::string> hashesOf(const Terms& terms, const std::vector<std::string>& hashes) {
  std::vector<std::string> found;
  for (std::size_t i = 0; i < terms.nodes.size(); ++i)
    found.push_back((terms.negative[i] ? "-" : "") +
                    (terms.nodes[i] == kNoNode ? std::string("constant") : hashes[static_cast<std::size_t>(terms.nodes[i])]));
  return found;
}

std::string hashOfChain(const std::string& kind, const std::vector<std::string>& terms) {
  std::string text = kind;
  for (const std::string& term : terms) text += " " + term;
  return contentHash(text);
}

std::map<std::string, int> countOperations(const ValueGraph& graph, const std::vector<int>& nodes) {
  std::map<std::string, int> counts;
  const std::vector<bool> needed = neededNodes(graph, nodes);
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (!needed[i]) continue;
    const char* name = spvOpcodeString(static_cast<std::uint32_t>(graph.nodes[i].instruction->opcode));
    ++counts[name == nullptr ? "other" : name];
  }
  return counts;
}

std::vector<std::string> inputsOf(const ShaderAnalysis& analysis, const std::vector<int>& nodes) {
  std::set<std::string> names;
  for (const int node : nodes)
    for (const int input : analysis.inputs_of[static_cast<std::size_t>(node)]) {
      const InputSource& source = analysis.inputs[static_cast<std::size_t>(input)];
      names.insert(std::string(nameOf(source.kind)) + " " + source.name);
    }
  return {names.begin(), names.end()};
}

struct Hashes {
  std::vector<std::string> slice, shape;
};

IdentifiedValue identify(const PreparedShader& shader, const ShaderAnalysis& analysis, const Hashes& hashes, const CandidateValue& value) {
  Terms terms = termsOf(value, analysis.graph);
  IdentifiedValue identity;
  identity.name = value.name;
  identity.operation = value.operation;
  identity.type = value.type;
  identity.file = std::filesystem::path(value.place.file).filename().string();
  identity.line = value.place.line;
  if (value.regrouping) {
    identity.chain = nameOf(value.regrouping->chain.kind);
    identity.terms = hashesOf(terms, hashes.slice);
    identity.slice = hashOfChain(identity.chain, identity.terms);
    identity.shape = hashOfChain(identity.chain, hashesOf(terms, hashes.shape));
  } else {
    identity.slice = hashes.slice[static_cast<std::size_t>(value.node)];
    identity.shape = hashes.shape[static_cast<std::size_t>(value.node)];
  }
  identity.text = textOf(value.regrouping ? termsOfChain(shader, analysis, value.regrouping->chain, value.regrouping->kept)
                                          : termsOfValue(shader, analysis, value.node));
  std::erase(terms.nodes, kNoNode);
  identity.operations = countOperations(analysis.graph, terms.nodes);
  identity.inputs = inputsOf(analysis, terms.nodes);
  return identity;
}

class PayloadFinder {
 public:
  PayloadFinder(const PreparedShader& shader, const ShaderAnalysis& analysis, const std::vector<SourceFile>& sources)
      : shader_(shader), analysis_(analysis), places_(shader, sources),
        hashes_{hashValues(shader, analysis), hashValues(shader, analysis, false)} {}

  Result<WantedValue> find(const IdentifiedValue& wanted) const {
    const std::optional<WantedValue> found = wanted.chain.empty() ? findValue(wanted) : findChain(wanted);
    if (found) return *found;
    return stale(wanted);
  }

 private:
  std::string nameAt(std::size_t node) const {
    const auto named = shader_.named.find(analysis_.graph.nodes[node].instruction->result_id);
    return named == shader_.named.end() ? "" : named->second.name;
  }

  int lineAt(std::size_t node) const { return places_.placeOf(*analysis_.graph.nodes[node].instruction).line; }

  // Values of one structure are equal; the hints only tell which of them the payload was.
  std::optional<WantedValue> findValue(const IdentifiedValue& wanted) const {
    std::optional<WantedValue> best;
    int best_likeness = -1;
    for (std::size_t i = 0; i < hashes_.slice.size(); ++i) {
      if (!analysis_.live[i] || hashes_.slice[i] != wanted.slice) continue;
      const int likeness = 2 * (nameAt(i) == wanted.name) + (lineAt(i) == wanted.line);
      if (likeness <= best_likeness) continue;
      best = WantedValue{static_cast<int>(i), std::nullopt};
      best_likeness = likeness;
    }
    return best;
  }

  std::optional<WantedValue> findChain(const IdentifiedValue& wanted) const {
    for (Chain& chain : findChains(shader_.module, *findFunction(shader_.module, shader_.entry_function))) {
      const auto root = analysis_.graph.node_of.find(chain.root);
      if (nameOf(chain.kind) != wanted.chain || root == analysis_.graph.node_of.end() || !analysis_.live[static_cast<std::size_t>(root->second)])
        continue;
      Regrouping regrouping{std::move(chain), {}};
      regrouping.kept.assign(regrouping.chain.terms.size(), true);
      const std::vector<std::string> terms = hashesOf(termsOf(asValue(regrouping, root->second), analysis_.graph), hashes_.slice);
      std::size_t next = 0;
      for (std::size_t i = 0; i < terms.size(); ++i) {
        regrouping.kept[i] = next < wanted.terms.size() && terms[i] == wanted.terms[next];
        next += regrouping.kept[i];
      }
      if (next == wanted.terms.size() && next < terms.size()) return WantedValue{root->second, std::move(regrouping)};
    }
    return std::nullopt;
  }

  static CandidateValue asValue(const Regrouping& regrouping, int node) {
    CandidateValue value;
    value.node = node;
    value.regrouping = regrouping;
    return value;
  }

  // The value that the user would take for the payload: of its name, else of its operation on its line; the last one.
  std::optional<std::size_t> successorOf(const IdentifiedValue& wanted) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < hashes_.slice.size(); ++i) {
      const Instruction& instruction = *analysis_.graph.nodes[i].instruction;
      if (!analysis_.live[i] || instruction.type_id == 0) continue;
      const char* operation = spvOpcodeString(static_cast<std::uint32_t>(instruction.opcode));
      const bool same = wanted.name.empty() || !wanted.chain.empty()
                            ? lineAt(i) == wanted.line && operation != nullptr && wanted.operation == operation
                            : nameAt(i) == wanted.name;
      if (same) found = i;
    }
    return found;
  }

  bool mayReplace(const IdentifiedValue& wanted, std::size_t node) const {
    const Instruction& instruction = *analysis_.graph.nodes[node].instruction;
    if (!analysis_.live[node] || analysis_.graph.nodes[node].loop_depth > 0 || instruction.type_id == 0) return false;
    const char* operation = spvOpcodeString(static_cast<std::uint32_t>(instruction.opcode));
    return operation != nullptr && wanted.operation == operation && nameOf(payloadType(shader_.module, instruction.type_id)) == wanted.type;
  }

  // Where nothing has its name or stands in its place: the value whose terms are the nearest, if most of them are the same.
  std::optional<std::size_t> nearestTo(const IdentifiedValue& wanted, const SliceTerms& before) const {
    std::optional<std::size_t> nearest;
    double least = kMostEdited;
    int compared = 0;
    for (std::size_t i = 0; i < hashes_.slice.size() && compared < kMostCompared; ++i) {
      if (!mayReplace(wanted, i)) continue;
      ++compared;
      const double edited = shareEdited(before, termsOfValue(shader_, analysis_, static_cast<int>(i)));
      if (edited > least || (edited == least && nearest)) continue;
      least = edited;
      nearest = i;
    }
    return nearest;
  }

  // The chain of this kind that the fewest edits lead to, if most of the kept terms are left or only edited.
  std::optional<std::size_t> nearestChain(const IdentifiedValue& wanted, const SliceTerms& before) const {
    std::optional<std::size_t> nearest;
    std::size_t fewest = 0;
    for (const Chain& chain : findChains(shader_.module, *findFunction(shader_.module, shader_.entry_function))) {
      const auto root = analysis_.graph.node_of.find(chain.root);
      if (nameOf(chain.kind) != wanted.chain || root == analysis_.graph.node_of.end() || !analysis_.live[static_cast<std::size_t>(root->second)]) continue;
      const std::vector<SliceChange> edits = changesOfKept(before, termsOfChain(shader_, analysis_, chain, std::vector<bool>(chain.terms.size(), true)));
      const auto gone = static_cast<std::size_t>(std::count_if(edits.begin(), edits.end(), [](const SliceChange& one) { return one.gone; }));
      if (2 * gone >= wanted.terms.size() || (nearest && edits.size() >= fewest)) continue;
      fewest = edits.size();
      nearest = static_cast<std::size_t>(root->second);
    }
    return nearest;
  }

  Error stale(const IdentifiedValue& wanted) const {
    const std::string advice = "; choose again with 'reprise optimize', or play the original with --on-stale=original";
    std::string title = "the payload " + (wanted.name.empty() ? wanted.operation : "'" + wanted.name + "'") + " of line " +
                        std::to_string(wanted.line) + " of " + wanted.file;
    const std::optional<SliceTerms> before = termsOfText(wanted.text);
    std::optional<std::size_t> successor = successorOf(wanted);
    if (!successor && before && !wanted.chain.empty()) successor = nearestChain(wanted, *before);
    if (!successor && before && wanted.chain.empty()) {
      successor = nearestTo(wanted, *before);
      if (successor && !wanted.name.empty() && !nameAt(*successor).empty()) title += " is renamed '" + nameAt(*successor) + "' and";
    }
    if (!successor) return {ErrorKind::kInput, "choice.stale", title + " is no longer in the shader" + advice, {wanted.file, 0, 0}};
    Place place = places_.placeOf(*analysis_.graph.nodes[*successor].instruction);
    std::string what = before ? edits(wanted, *before, *successor, place) : "";
    if (what.empty()) what = changes(wanted, *successor);
    return {ErrorKind::kInput, "choice.stale", title + " has changed since it was chosen: " + what + advice, place};
  }

  std::vector<SliceChange> editsOf(const IdentifiedValue& wanted, const SliceTerms& before, std::size_t node) const {
    if (wanted.chain.empty()) return changesBetween(before, termsOfValue(shader_, analysis_, static_cast<int>(node)));
    for (const Chain& chain : findChains(shader_.module, *findFunction(shader_.module, shader_.entry_function)))
      if (chain.root == analysis_.graph.nodes[node].instruction->result_id)
        return changesOfKept(before, termsOfChain(shader_, analysis_, chain, std::vector<bool>(chain.terms.size(), true)));
    return {};
  }

  // What was edited, each with its place; `first` becomes the place of the first of them. Empty where the terms do not tell.
  std::string edits(const IdentifiedValue& wanted, const SliceTerms& before, std::size_t node, Place& first) const {
    const std::vector<SliceChange> found = editsOf(wanted, before, node);
    std::string text;
    for (std::size_t i = 0; i < found.size() && i < kMostToldEdits; ++i) {
      text += (text.empty() ? "" : ", ") + found[i].text;
      if (found[i].node == kNoNode) continue;
      const Place place = places_.placeOf(*analysis_.graph.nodes[static_cast<std::size_t>(found[i].node)].instruction);
      if (place.line == 0) continue;
      if (i == 0) first = place;
      text += " (" + std::filesystem::path(place.file).filename().string() + ":" + std::to_string(place.line) + ")";
    }
    if (found.size() > kMostToldEdits) text += ", and " + std::to_string(found.size() - kMostToldEdits) + " more";
    if (text.empty() || !wanted.chain.empty()) return text;
    for (const std::string& input : inputChanges(wanted, identityOf(node), text)) text += ", " + input;
    return text;
  }

  IdentifiedValue identityOf(std::size_t node) const {
    CandidateValue value;
    value.node = static_cast<int>(node);
    return identify(shader_, analysis_, hashes_, value);
  }

  // Without those that `told` names as replaced: "texture 'noise'".
  static std::vector<std::string> inputChanges(const IdentifiedValue& before, const IdentifiedValue& now, const std::string& told = "") {
    std::vector<std::string> found;
    const auto isTold = [&](const std::string& input) { return told.find("'" + input.substr(input.find(' ') + 1) + "'") != std::string::npos; };
    for (const std::string& input : now.inputs)
      if (!std::binary_search(before.inputs.begin(), before.inputs.end(), input) && !isTold(input)) found.push_back("it now depends on " + input);
    for (const std::string& input : before.inputs)
      if (!std::binary_search(now.inputs.begin(), now.inputs.end(), input) && !isTold(input)) found.push_back("it no longer depends on " + input);
    return found;
  }

  // Without text: what it has more and less of.
  std::string changes(const IdentifiedValue& before, std::size_t node) const {
    if (!before.chain.empty()) return "its kept terms are no longer those that were chosen";
    const IdentifiedValue now = identityOf(node);
    std::vector<std::string> found = inputChanges(before, now);
    std::map<std::string, int> difference = now.operations;
    for (const auto& [operation, count] : before.operations) difference[operation] -= count;
    for (const auto& [operation, count] : difference)
      if (count != 0) found.push_back(std::to_string(std::abs(count)) + " " + operation + (count > 0 ? " more" : " less"));
    if (found.empty()) return now.shape == before.shape ? "a constant in what computes it" : "how its operations are joined";
    std::string text = found.front();
    for (std::size_t i = 1; i < found.size(); ++i) text += ", " + found[i];
    return text;
  }

  const PreparedShader& shader_;
  const ShaderAnalysis& analysis_;
  PlaceFinder places_;
  Hashes hashes_;
};

}  // namespace

std::vector<IdentifiedValue> identifyPayload(const PreparedShader& shader, const ShaderAnalysis& analysis, const Candidate& candidate) {
  const Hashes hashes{hashValues(shader, analysis), hashValues(shader, analysis, false)};
  std::vector<IdentifiedValue> identified;
  for (const CandidateValue& value : candidate.values) identified.push_back(identify(shader, analysis, hashes, value));
  return identified;
}

Result<Candidate> findPayload(const PreparedShader& shader, const ShaderAnalysis& analysis, const std::vector<SourceFile>& sources,
                              const std::vector<IdentifiedValue>& payload) {
  const PayloadFinder finder(shader, analysis, sources);
  std::vector<WantedValue> wanted;
  for (const IdentifiedValue& value : payload) {
    REPRISE_ASSIGN(WantedValue found, finder.find(value));
    wanted.push_back(std::move(found));
  }
  Candidate candidate = candidateOf(shader, analysis, sources, wanted);
  // What the recipe says of the payload is what it said when it was chosen: of parts of chains the name is made up.
  for (std::size_t i = 0; i < payload.size(); ++i)
    if (!payload[i].chain.empty()) candidate.values[i].name = payload[i].name;
  if (!candidate.kept())
    return Error{ErrorKind::kInput, "choice.unsafe", "the payload can no longer be kept: " + candidate.dropped.message + " [" + candidate.dropped.code + "]",
                 candidate.place};
  return candidate;
}

}  // namespace reprise
