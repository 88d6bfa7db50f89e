// Robust linear least squares with coefficients ≥ 0: minimizes Σ ρ((x_i·b − t_i) / w_i) over b ≥ 0, where w_i is the prediction
// x_i·b of the round before (relative residuals) and ρ is Huber's loss (Ceres). Used by fit_cost.cpp.
#pragma once

#include <span>
#include <vector>

namespace reprise {

// One row: up to three regressors and the observed value, all of order 1.
struct LinearRow {
  double terms[3] = {};
  double observed = 0;
};

struct RobustLinearFit {
  std::vector<double> coefficients;
  std::vector<double> standard_errors;  // as if no bound were active; infinite where the rows do not determine them
  double scatter = 0;                   // robust standard deviation of the relative residuals
  bool converged = false;
};

// The first term_count terms of each row are used; rows must not be empty and observed must be positive (checked).
RobustLinearFit fitRobustLinear(std::span<const LinearRow> rows, int term_count, int max_iterations);

// The least singular value of the rows, each divided by its observed value, over √rows: how well the terms can be told
// apart; 0 if they cannot.
double leastSingularValue(std::span<const LinearRow> rows, int term_count);

}  // namespace reprise
