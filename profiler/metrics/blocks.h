// Visible blocks: how much more the error steps between neighbours whose payloads are of unlike age than between those of like age.
//
// e is the mean over channels of cached − original. Over the pairs of horizontal and vertical neighbours within a tile (tiles.h) that are
// both covered:
//
//   blocks = max(0, rms of e(p) − e(q) where age(p) ≠ age(q)  −  rms of e(p) − e(q) where age(p) = age(q)) · gain
//
// The second term is what resampling and texture do to errors anywhere; the first is what the border of a refreshed block adds. Ages are
// counted by the instrumented copy, so any pattern and any history is judged alike. A tile with fewer than 32 pairs of unlike age says
// nothing, nor does a variant that counts no ages. Known to be wrong: where texture hides the step, it counts all the same, and on a
// flat surface seams of one or two pixels are seen that are below the level good.
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric blocksMetric();

}  // namespace reprise
