// Root of the mean squared difference of each tile's covered pixels and channels, at the exposure of tiles.h:
//
//   tile_rms = sqrt(mean((cached − original)²)) · gain
//
// and the same of the frame-to-frame change of that difference, tile_flicker: what flickers in the variant and not in the original. In [0, 1]; the
// first frame of a session has no change. Cheap: planning takes tile_rms in place of tile_flip.
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric tileRmsMetric();
Metric tileFlickerMetric();

}  // namespace reprise
