// Visible blocks: how much more the error steps between neighbours whose payloads are of unlike age than between those of like age.
//
// e is the mean over channels of cached − original. Over the pairs of horizontal and vertical neighbours within a tile (tiles.h) that are
// both covered:
//
//   excess = max(0, rms of e(p) − e(q) where age(p) ≠ age(q)  −  rms of e(p) − e(q) where age(p) = age(q)) · gain
//   blocks = excess / (1 + σ · gain · 255),   σ: rms of the steps of the original over all pairs
//
// The subtracted term is what resampling and texture do to errors anywhere; the rest is what the border of a refreshed block adds. σ masks it: a
// step that is plain on a flat surface is lost among steps of the image itself (contrast masking: G. E. Legge, J. M. Foley, "Contrast
// masking in human vision", JOSA 70(12), 1980; here in its simplest form, by which steps of 1/255 halve what is seen of a border). Ages are
// counted by the instrumented copy, so any pattern and any history is judged alike. A tile with fewer than 32 pairs of unlike age says
// nothing, nor does a variant that counts no ages. Known to be wrong: borders that run along an edge of the image are masked more than σ says.
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric blocksMetric();

}  // namespace reprise
