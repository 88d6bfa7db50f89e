// The rms of the frame over the mean luminance (0.2126 R + 0.7152 G + 0.0722 B as displayed) of its covered pixels in the original: 0.02 in a
// frame of mean 0.12 is a sixth. At most 1; 1 where the original is black and the variant is not.
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric relativeRmsMetric();

}  // namespace reprise
