// Pixels in which a shader enlarges rounding errors: varyings that are off by a few units in the last place change the original's
// colour visibly (a loop that ends by a threshold, a hash of a float). There a driver's freedom to round shows, whatever the rewrite
// does, so that a difference says nothing.
#pragma once

#include <string>
#include <vector>

#include "profiler/harness/harness.h"

namespace reprise {

struct OriginalPlay {
  const Context& context;
  Commands& commands;
  const ShaderInterface& interface;
  const Package& package;
  HarnessOptions options;
};

// By frame and pixel, for frames 0.. that the original showed as `originals`. Errors: those of Harness.
Result<std::vector<std::vector<bool>>> unsteadyPixels(const OriginalPlay& play, const std::vector<HarnessFrame>& originals);

// "", or that more than a tenth of the covered pixels of some frame are unsteady.
std::string whyMostlyUnsteady(const std::vector<std::vector<bool>>& unsteady, const std::vector<HarnessFrame>& originals);

}  // namespace reprise
