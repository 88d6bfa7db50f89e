// The laws that a played frame is held to, against the original's frame of the same moment (the design's laws 1 to 4).
#pragma once

#include <optional>
#include <string>

#include "profiler/harness/harness.h"

namespace reprise {

struct Violation {
  std::string law;       // "law.always_refresh", "law.misses_exact", "law.frozen_world", "law.books", "law.depth"
  std::size_t pixel = 0; // index, rows from the top
  std::string expected, found;
};

// Which pixels' colours must equal the original's, bit for bit (one NaN is as good as another).
enum class ExactPixels { kAll, kMisses };

// tolerance: how far floats may be off, relative to the larger of 1 and the value; 0: not by a bit.
struct ColorLaw {
  std::string name;
  ExactPixels pixels = ExactPixels::kAll;
  double tolerance = 0;
  bool computed_depth = false;  // depth is a float of the shader's, and the tolerance holds for it, too
  // Depth tells what was drawn; not so where tests come before a shader that discards: its depth is kept all the same.
  bool depth_tells_coverage = true;
  const std::vector<bool>* left_out = nullptr;  // pixels whose colours are not compared
};

// Depth must equal the original's everywhere, and exactly the pixels that are neither hit nor miss must show the clear depth.
std::optional<Violation> findViolation(const HarnessFrame& original, const HarnessFrame& played, const ColorLaw& law);

bool covered(const HarnessFrame& frame, std::size_t pixel);  // by depth

// Of two images of one output; tolerance as in ColorLaw.
bool samePixel(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b, std::size_t pixel, double tolerance);

// Whether two originals' frames have the same colours, within a tolerance as ColorLaw has it.
bool sameColors(const HarnessFrame& a, const HarnessFrame& b, double tolerance);

// Of the original's frame: why it would show nothing, or "": too little covered, not finite, or the same everywhere.
std::string whyMeaningless(const HarnessFrame& original, const std::vector<FragmentOutput>& outputs);

std::size_t countKind(const HarnessFrame& frame, std::uint8_t kind);  // 1 hits, 2 misses

}  // namespace reprise
