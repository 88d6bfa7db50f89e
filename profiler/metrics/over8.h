// Share of covered pixels whose largest channel difference exceeds 8/255, the threshold of perception in Mueller et al. 2021.
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric over8Metric();

}  // namespace reprise
