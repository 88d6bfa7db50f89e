// Root mean square: sqrt(mean over covered pixels and the 3 channels of (cached − original)²). In [0, 1].
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric rmsMetric();

}  // namespace reprise
