// Mean absolute difference over covered pixels and the 3 channels. In [0, 1].
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric meanDifferenceMetric();

}  // namespace reprise
