// The 95th percentile (nearest rank) over covered pixels of the mean over channels of |cached − original|. In [0, 1].
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric p95Metric();

}  // namespace reprise
