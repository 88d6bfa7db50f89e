// What all metrics share: the check of their inputs and the walk over covered pixels.
#pragma once

#include <cstddef>

#include "profiler/metrics/metrics.h"
#include "runtime/base/check.h"

namespace reprise {

inline void checkInputs(const MetricInputs& inputs) {
  REPRISE_CHECK(inputs.original && inputs.cached && inputs.mask, inputs.original, inputs.cached, inputs.mask);
  const CoverageMask& mask = *inputs.mask;
  const std::size_t pixels = static_cast<std::size_t>(mask.width) * mask.height;
  REPRISE_CHECK(mask.kind.size() == pixels, mask.kind.size(), mask.width, mask.height);
  for (const DisplayImage* image : {inputs.original, inputs.cached, inputs.last_original, inputs.last_cached}) {
    if (!image) continue;
    REPRISE_CHECK(image->width == mask.width && image->height == mask.height, image->width, image->height, mask.width,
                  mask.height);
    REPRISE_CHECK(image->rgb.size() == 3 * pixels, image->rgb.size(), pixels);
  }
}

// Calls visit(pixel) for each covered pixel, row by row, and returns their number.
template <typename Visit>
std::size_t visitCovered(const CoverageMask& mask, Visit visit) {
  std::size_t covered = 0;
  for (std::size_t pixel = 0; pixel < mask.kind.size(); ++pixel) {
    if (mask.kind[pixel] == 0) continue;
    ++covered;
    visit(pixel);
  }
  return covered;
}

}  // namespace reprise
