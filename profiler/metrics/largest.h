// The largest difference of a channel of a covered pixel, in [0, 1]; of a session that of its worst frame.
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric largestMetric();

}  // namespace reprise
