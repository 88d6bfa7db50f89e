// RMS over covered pixels and channels of the change of (cached − original) from the frame before to this one; at most 1 (it is
// cut there). 0 in the first frame. Sees what still images do not: refreshes that pop.
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric flickerMetric();

}  // namespace reprise
