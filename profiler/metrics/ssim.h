// 1 − SSIM (Wang et al. 2004) of Rec. 709 luma as displayed: Gaussian window of 11×11, σ = 1.5, C1 = 0.01², C2 = 0.03².
// Windows are centred on covered pixels and weigh covered pixels only; a negative SSIM counts as 0, so that the mean lies in
// [0, 1]. Known to be wrong: blind to colour at equal luma, and to flicker.
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric ssimMetric();

}  // namespace reprise
