#include "compiler/candidates/prune.h"

#include <algorithm>
#include <cmath>

namespace reprise {
namespace {

bool dependsOnNoMore(const Candidate& a, const Candidate& b) {
  return std::includes(b.inputs.begin(), b.inputs.end(), a.inputs.begin(), a.inputs.end());
}

std::string described(const Candidate& candidate) {
  const std::string name = candidate.name.empty() ? candidate.operation : "'" + candidate.name + "'";
  return name + " (line " + std::to_string(candidate.place.line) + ")";
}

// True if `a` is the one to keep of two that save the same.
bool preferred(const Candidate& a, const Candidate& b) {
  if (a.inputs.size() != b.inputs.size()) return a.inputs.size() < b.inputs.size();
  if (a.channels != b.channels) return a.channels < b.channels;
  if (a.name.empty() != b.name.empty()) return !a.name.empty();
  return a.saved_cost > b.saved_cost || (a.saved_cost == b.saved_cost && a.node > b.node);
}

}  // namespace

void pruneCandidates(std::vector<Candidate>& ranked, double shader_cost, const CandidateOptions& options) {
  for (Candidate& candidate : ranked)
    if (candidate.kept() && candidate.share < options.least_share)
      candidate.dropped = {"pruned.cheap", "caching it would save " + std::to_string(std::lround(candidate.share * 1000) / 10.0).substr(0, 4) +
                                               "% of the shader's cost, too little to pay for a lookup"};
  const double same = options.same_cost_share * shader_cost;
  for (Candidate& candidate : ranked) {
    if (!candidate.kept()) continue;
    for (const Candidate& other : ranked) {
      if (&other == &candidate || !other.kept()) continue;
      const bool alike = std::abs(other.saved_cost - candidate.saved_cost) <= same;
      if (alike && dependsOnNoMore(other, candidate) && preferred(other, candidate)) {
        candidate.dropped = {"pruned.duplicate", described(other) + " saves as much and is no harder to keep"};
        break;
      }
      const bool strictly = other.saved_cost > candidate.saved_cost || other.channels < candidate.channels ||
                            other.inputs.size() < candidate.inputs.size();
      if (other.saved_cost >= candidate.saved_cost && other.channels <= candidate.channels &&
          dependsOnNoMore(other, candidate) && strictly && other.conditional <= candidate.conditional) {
        candidate.dropped = {"pruned.dominated", described(other) + " saves at least as much and changes with no more inputs"};
        break;
      }
    }
  }
  std::size_t kept = 0;
  for (Candidate& candidate : ranked)
    if (candidate.kept() && ++kept > options.most)
      candidate.dropped = {"pruned.rank", "only the " + std::to_string(options.most) + " candidates that save most are trained"};
}

}  // namespace reprise
