// LDR-FLIP: mean over covered pixels of ΔE = (ΔE_c)^(1 − ΔE_f), in [0, 1]. ΔE_c is the colour difference after filtering
// with contrast sensitivity functions, ΔE_f that of edges and points.
// Source: P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020, sections 4.1 (colour pipeline),
// 4.2 (feature pipeline) and 4.3 (final difference), with the constants of the authors' published code.
// Images are taken as sRGB-encoded, seen at 67 pixels per degree (a 0.7 m wide screen of 3840 pixels at 0.7 m). The filters
// reach over the border of the mask: uncovered pixels count as the original has them, in both images.
// Known to be wrong: blind to flicker; too strict where the viewer sits further away.
#pragma once

#include "profiler/metrics/metrics.h"

namespace reprise {

Metric flipMetric();

}  // namespace reprise
