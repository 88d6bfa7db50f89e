#include "bench/published_cases.h"

#include <algorithm>

namespace reprise {
namespace {

bool reads(const RunCandidate& candidate, const std::string& input) {
  return std::find(candidate.inputs.begin(), candidate.inputs.end(), input) != candidate.inputs.end();
}

bool isAlbedo(const RunCandidate& candidate) {
  return candidate.inputs == std::vector<std::string>{"varying object_position"} && candidate.cost_share > 0.5;
}

bool is24Of25(const RunCandidate& candidate) { return candidate.name.rfind("24 of the 25 terms", 0) == 0; }

bool isStandingOcclusion(const RunCandidate& candidate) {
  return reads(candidate, "texture standing_discs") && !reads(candidate, "texture king_discs") && candidate.cost_share > 0.5;
}

bool isLit(const RunCandidate& candidate) { return candidate.name == "lit" || candidate.name == "color"; }

}  // namespace

const std::vector<PublishedCase>& publishedCases() {
  static const std::vector<PublishedCase> cases = {
      {"marble5", "marble/marble.toml", "2.8x at an acceptable threshold (Scherzer et al. 2012, fig. 7-8)", 1.1, "albedo", isAlbedo},
      {"marble20", "marble/marble20.toml", "as marble5, at 20 octaves", 2.3, "albedo", isAlbedo},
      {"trashcan", "trashcan/trashcan.toml", "2.1x, 24 of 25 samples kept (Scherzer et al. 2012, 5.1)", 2.1, "24 of 25 samples", is24Of25},
      {"chess", "chess/chess.toml", "8x, static occlusion kept (Scherzer et al. 2012, 5.1)", 8.0, "static occlusion", isStandingOcclusion},
      {"translucent", "translucent/translucent.toml", "1.3x, never refreshed (Nehab et al. 2007, 7.1)", std::nullopt, "", nullptr},
      {"dragon", "dragon/dragon.toml", "1.7x tiled, 1.9x random, every 4 frames, final colour kept (Nehab et al. 2007, fig. 6)", 1.7, "final colour", isLit},
      {"stereo", "stereo/stereo.toml", "1.57x final colour, 1.39x albedo alone (Nehab et al. 2007, 7.2)", 1.4, "albedo", isAlbedo},
      {"crowd", "crowd/crowd.toml", "over 90% of the surface stays visible (Nehab et al. 2007, fig. 3)", std::nullopt, "", nullptr},
      {"worst", "worst/worst.toml", "nothing; a gain must hold, else the original", std::nullopt, "", nullptr}};
  return cases;
}

std::optional<std::size_t> rankOfNamed(const PublishedCase& one, const std::vector<RunCandidate>& candidates) {
  if (one.is_named == nullptr) return std::nullopt;
  const auto found = std::find_if(candidates.begin(), candidates.end(), one.is_named);
  if (found == candidates.end()) return std::nullopt;
  return static_cast<std::size_t>(found - candidates.begin()) + 1;
}

}  // namespace reprise
