// Hand-written packages whose results can be told without rendering: what the player does, and nothing of a strategy.
#pragma once

#include <cstdint>

#include "runtime/package/package.h"

namespace reprise {

// A rectangle. All but the id are its push constants (32 bytes): corners x0, y0, x1, y1 in clip space, depth, two numbers.
struct Quad {
  std::uint64_t id = 1;
  float rect[4] = {-1, -1, 1, 1};
  float depth = 0.5f;
  float first = 0, second = 0;
  float unused = 0;
};

// "original" in both places: writes (first, second, depth, 1).
Package originalPackage();
// The original behind a depth prepass.
Package prepassPackage();
// History "cache": its value of last frame plus one, 1 where the history is not valid; at location 2, so that 1 is a gap.
Package accumulatingPackage();
// Writes (frame, period_frames, history_valid, previous viewport's width).
Package uniformsPackage();
// Writes (valid_last_frame, last frame's `first`, this frame's `first`, last frame's block value). The block is "Object" in
// the application's set 0; Reprise's set is 2, so that 1 is empty.
Package previousPackage();
// Rendering 0 writes `first` to frame resource "mid" without the application's target, rendering 1 writes ten times it.
Package twoRenderingsPackage();
// Adds (1, 2, 0, 0) to "counts" for each fragment.
Package countingPackage();
// Only the first fragment of a pixel is drawn, by the stencil.
Package stencilPackage();
// Draws all quads in (0.5, 0.5, 0.5, 1) and flags those whose `first` is above 4; then draws what is flagged as the original does.
Package flaggedPackage();

}  // namespace reprise
