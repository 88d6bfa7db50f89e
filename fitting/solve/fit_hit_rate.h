// Fits μ of λ(n) = μ (1 − 1/n) (hit_rate_model.h) to measured hit rates: weighted linear least squares,
// μ = Σ w x y / Σ w x² with x = 1 − 1/n, y the hit rate, w the covered pixels, held in [0, 1].
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fitting/models/fit_verdict.h"
#include "fitting/models/hit_rate_model.h"

namespace reprise {

struct HitRatePoint {
  std::uint32_t period_frames = 1;  // 0: never
  double hits = 0, covered = 0;     // pixels, over the frames of a session; frames that all miss by definition left out
};

struct HitRateFit {
  FittedParameter mu{"mu", 0, 0, 1};
  std::vector<double> residuals;  // measured − predicted rate, one per point used, in the order given
  double r_squared = 0;
  FitVerdict verdict = FitVerdict::kNoPoints;
  std::string explanation;
};

// Period 1 and points without covered pixels are left out. Never fails.
HitRateFit fitHitRate(std::span<const HitRatePoint> points);

}  // namespace reprise
