// Images as metrics see them: RGB as displayed, and which pixels count.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

// Row by row from the top, three floats per pixel, as displayed: tone mapped and clamped to [0, 1].
struct DisplayImage {
  int width = 0, height = 0;
  std::vector<float> rgb;
};

// One byte per pixel: 0 not covered by the cached shader, 1 hit, 2 miss.
struct CoverageMask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> kind;
};

// 8-bit PNG, whole or not at all. Errors: file.unwritable.
Result<void> writePng(const DisplayImage& image, const std::filesystem::path& path);
// PNG bytes in memory, for reports.
std::vector<std::uint8_t> encodePng(const DisplayImage& image);

}  // namespace reprise
