// The differential test of the rewrites on one module: the original against every variant, frame by frame, on made-up inputs.
//
// The best candidates are taken in every strategy with nearest fetches, interleaved 4x4 blocks and the 32-bit float encoding. Each
// variant must equal the original in all pixels at period 1, in the pixels that miss under motion at period 4, and everywhere in a
// world that stands still. `verified` needs inputs under which this says something: the original covers a tenth of the image, is
// finite and not constant, hits and misses occur, and a poisoned cache changes the image; other seeds and
// candidates are tried before giving up.
//
// Undefined values are made zero in the original and the variants alike (compiler/ir/reproducible.h). Where the bits differ, the
// module is verified all the same, and the reason says so, if the difference is at most 1e-5 of the value, or if the bits are
// equal with NoContraction on both sides and the difference as given is at most 1e-3: drivers expand and fuse
// operations differently in other surroundings. A module that enlarges rounding errors itself is verified, at 1e-3, in the pixels
// where it does not (unsteady_pixels.h), nine tenths at least.
#pragma once

#include <functional>

#include "cli/check/verdict.h"

namespace reprise {

// `original_runs` is called once the original has been played: a crash after that is ours.
ModuleVerdict checkModule(const CheckRequest& request, const std::function<void()>& original_runs);

}  // namespace reprise
