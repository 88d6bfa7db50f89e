// Levels of quality: what --quality binds.
//
// The numbers are measured: in the shipped scenes the differences of a cached variant that is hardly ever refreshed were capped at T of 255
// per channel, and the thresholds are what the metrics gave there (docs/metrics.md has the table; bench/quality_levels makes it again). T comes
// from J. Mueller et al., "Temporally Adaptive Shading Reuse for Real-Time Rendering and Virtual Reality", ACM TOG 40(2), 2021, sections 3
// and 7.2: differences of up to T = 4, 8 and 16 were seen by 50%, 55 to 60% and just under 75% of people, where 50% is chance.
#pragma once

#include <span>
#include <string>

#include "profiler/metrics/error_limits.h"

namespace reprise {

struct Quality {
  std::string name;        // "imperceptible", "good", "draft"
  int capped_at = 0;       // T
  ErrorLimits binding;     // judged in validation
  ErrorLimits planning;    // what training models instead: tile_flip costs too much there, tile_rms takes its place
};

// From the strictest.
std::span<const Quality> qualities();
const Quality* findQuality(const std::string& name);
inline constexpr const char* kDefaultQuality = "good";

}  // namespace reprise
