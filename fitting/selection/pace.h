// How fast the machine went in one run against another, by what the original took for the same work in both.
//
//   pace = (t / f) / (t0 / f0),   t, t0: the original's time per frame, f, f0: fragments shaded per frame
//
// 1 for equal runs; 1.2 where the later run took a fifth longer. A frame time that a model of the first run predicts is to be
// multiplied by it before it is held against one of the second. Wrong where the original's cost per fragment depends on
// what is in view.
#pragma once

namespace reprise {

struct FrameWork {
  double frame_ms = 0;             // the faster of the original with and without a depth prepass
  double fragments_per_frame = 0;  // overdraw included
};

// NaN where either run has no fragments or no time.
double paceOf(const FrameWork& training, const FrameWork& validation);

}  // namespace reprise
