// The laws that a played frame is held to, against the original's frame of the same moment (the design's laws 1 to 4).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "profiler/harness/harness.h"
#include "profiler/metrics/rounding.h"

namespace reprise {

struct Violation {
  std::string law;       // "law.always_refresh", "law.misses_exact", "law.frozen_world", "law.books", "law.depth"
  std::size_t pixel = 0; // index, rows from the top
  std::string expected, found;
};

// Which pixels' colours must equal the original's.
enum class ExactPixels { kAll, kMisses };

// tolerance: how far floats may be off, as rounding.h has it; 0: not at all.
struct ColorLaw {
  std::string name;
  ExactPixels pixels = ExactPixels::kAll;
  double tolerance = 0;
  std::vector<ChannelKind> kinds;  // by output; outputs beyond its end are floats
  bool computed_depth = false;  // depth is a float of the shader's, and the tolerance holds for it, too
  // Depth tells what was drawn; not so where tests come before a shader that discards: its depth is kept all the same.
  bool depth_tells_coverage = true;
  const std::vector<bool>* left_out = nullptr;  // pixels whose colours are not compared (null: none is left out)
};

// Depth must equal the original's everywhere, and exactly the pixels that are neither hit nor miss must show the clear depth.
std::optional<Violation> findViolation(const HarnessFrame& original, const HarnessFrame& played, const ColorLaw& law);

bool covered(const HarnessFrame& frame, std::size_t pixel);  // by depth

// What the harness's targets hold for these outputs: floats or integers.
std::vector<ChannelKind> channelKinds(const std::vector<FragmentOutput>& outputs);

// Whether two frames of floats have the same colours, within a tolerance and but for pixels left out, as ColorLaw has them.
bool sameColors(const HarnessFrame& a, const HarnessFrame& b, double tolerance, const std::vector<bool>* left_out = nullptr);

// What an original's frame can show, but for pixels that are left out. kNothing: too little covered, or not finite. kConstant: the same everywhere, so that a
// comparison says something, but nothing of a cache.
enum class Showing { kNothing, kConstant, kVaries };
struct Meaning {
  Showing shows = Showing::kVaries;
  std::string why;  // empty if it varies
};
Meaning meaningOf(const HarnessFrame& original, const std::vector<FragmentOutput>& outputs, const std::vector<bool>* left_out = nullptr);

std::size_t countKind(const HarnessFrame& frame, std::uint8_t kind);  // 1 hits, 2 misses

}  // namespace reprise
