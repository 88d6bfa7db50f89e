// Fits Eq. 5 (cost_model.h) to measured frame times: robust least squares with all parameters ≥ 0 (Ceres, Huber loss).
//
// Times scatter in proportion to themselves, so residuals are taken relative to the predicted time (reweighted until it
// settles) and the Huber bend lies at 1.345 robust standard deviations (median absolute deviation).
// Terms count as told apart if the least singular value σ of the rows, scaled to a time of 1, exceeds 0.01 and scatter / (σ √N)
// stays under 0.5.
// Rows whose coverage does not vary cannot tell c from Δhit and Δmiss; rows whose share of misses does not vary cannot tell Δhit from
// Δmiss. Then c = 0, or Δhit = Δmiss, is assumed, the verdict is kUnidentifiable and the explanation says which: such a fit
// predicts well only at the coverage (or hit rate) that it has seen.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fitting/models/cost_model.h"
#include "fitting/models/fit_verdict.h"

namespace reprise {

// One frame: shaded fragments and the frame's time by the binding clock (ms).
struct CostPoint {
  double hits = 0, misses = 0;
  double frame_time_ms = 0;
};

struct CostFitOptions {
  int max_iterations = 200;
  double poor_scatter = 0.25;  // relative scatter above which the verdict is kPoor
};

struct CostFit {
  CostParameters cost;
  FittedParameter hit_ns{"hit_ns", 0, 0, 0}, miss_ns{"miss_ns", 0, 0, 0}, overhead_ms{"overhead_ms", 0, 0, 0};
  std::vector<double> residuals_ms;  // measured − predicted, one per point used, in the order given
  double scatter = 0;                // robust standard deviation of measured/predicted
  double r_squared = 0;              // against the mean time; near 0 if the times do not vary, however good the fit
  FitVerdict verdict = FitVerdict::kNoPoints;
  std::string explanation;           // "unidentifiable: coverage does not vary ..."
};

// Points without a fragment, with a time that is not positive or a number that is not finite are left out. Never fails.
// Deterministic.
CostFit fitCost(std::span<const CostPoint> points, const CostFitOptions& options = {});

// Eq. 5 in ms. NaN if the fit is not usable.
double predictFrameTime(const CostFit& fit, double hits, double misses);

}  // namespace reprise
