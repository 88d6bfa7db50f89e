// Whether a device draws a pixel of a module differently where other pixels of its group do not run.
//
// Devices run groups of pixels in step. Some get the mask of a loop wrong that these pixels leave after different numbers of turns: what
// a pixel shows then depends on which others run, and no comparison of images says anything. Seen with Mesa's CPU driver (22.3.6) and
// loops whose continue block is their body. The module runs in every other quad of a checkerboard, nothing else is changed:
//
//   void main() { if (((x / 2 + y / 2) & 1) == parity) original_main(); }
//
// Derivatives are those of the whole module, as quads run or do not run as a whole.
#pragma once

#include <functional>
#include <vector>

#include "compiler/ir/module.h"
#include "profiler/harness/harness.h"

namespace reprise {

// parity: 0 or 1. `given` has one entry point.
Module inEveryOtherQuad(const Module& given, std::uint32_t parity);

using PlayWords = std::function<Result<std::vector<HarnessFrame>>(const std::vector<std::uint32_t>& fragment_words)>;

// given: the frames of the module as given. True if a pixel that runs in either half differs from it by more than rounding
// (1e-5 of the larger of 1 and the value). Errors: those of the plays.
Result<bool> dependsOnNeighbours(const Module& module, const std::vector<HarnessFrame>& given, const PlayWords& play);

}  // namespace reprise
