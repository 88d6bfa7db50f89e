#include "compiler/candidates/prune.h"

#include <fmt/format.h>

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
  if (isRegrouped(a) != isRegrouped(b)) return isRegrouped(b);
  if (a.name.empty() != b.name.empty()) return !a.name.empty();
  return a.saved_cost > b.saved_cost || (a.saved_cost == b.saved_cost && a.values.front().node > b.values.front().node);
}

// Drops a candidate that another one makes needless.
void dropIfMatched(Candidate& candidate, const std::vector<Candidate>& ranked, double shader_cost, const CandidateOptions& options) {
  const double same = options.same_cost_share * shader_cost;
  for (const Candidate& other : ranked) {
    if (&other == &candidate || !other.kept() || !dependsOnNoMore(other, candidate)) continue;
    const double more = candidate.saved_cost - other.saved_cost;
    if (std::abs(more) <= same && preferred(other, candidate)) {
      candidate.dropped = {"pruned.duplicate", described(other) + " saves as much and is no harder to keep"};
      return;
    }
    const bool strictly = other.saved_cost > candidate.saved_cost || other.channels < candidate.channels ||
                          other.inputs.size() < candidate.inputs.size();
    if (more <= 0 && other.channels <= candidate.channels && strictly && other.conditional <= candidate.conditional) {
      candidate.dropped = {"pruned.dominated", described(other) + " saves at least as much and changes with no more inputs"};
      return;
    }
    const int channels = candidate.channels - other.channels;
    if (candidate.values.size() > 1 && channels > 0 && more < options.least_share_per_channel * shader_cost * channels) {
      candidate.dropped = {"pruned.channels", fmt::format("{} saves nearly as much in {} of its {} channels", described(other), other.channels,
                                                          candidate.channels)};
      return;
    }
  }
}

}  // namespace

void pruneCandidates(std::vector<Candidate>& ranked, double shader_cost, const CandidateOptions& options) {
  for (Candidate& candidate : ranked)
    if (candidate.kept() && candidate.share < options.least_share)
      candidate.dropped = {"pruned.cheap", "caching it would save " + std::to_string(std::lround(candidate.share * 1000) / 10.0).substr(0, 4) +
                                               "% of the shader's cost, too little to pay for a lookup"};
  for (Candidate& candidate : ranked)
    if (candidate.kept() && !candidate.steadier_part) dropIfMatched(candidate, ranked, shader_cost, options);
  std::size_t kept = 0, groups = 0, partials = 0;
  for (Candidate& candidate : ranked) {
    if (!candidate.kept()) continue;
    const bool fits = (candidate.values.size() < 2 || ++groups <= options.most_groups) &&
                      (!isRegrouped(candidate) || ++partials <= options.most_partials) && ++kept <= options.most;
    if (!fits)
      candidate.dropped = {"pruned.rank", fmt::format("only the {} candidates that save most are trained, of them {} of several values and {} parts of chains",
                                                      options.most, options.most_groups, options.most_partials)};
  }
}

}  // namespace reprise
