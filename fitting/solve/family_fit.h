// Fits one model of the error family by bounded, weighted least squares. Used by fit_error.cpp, which compares the models.
#pragma once

#include <span>
#include <vector>

#include "fitting/models/error_model.h"

namespace reprise {

struct FamilyFit {
  const ErrorModel* model = nullptr;
  std::vector<double> parameters;
  double chi_squared = 0;  // Σ ((ε_i − ε̂_i) / sigma_i)²
  bool converged = false;
};

// Every sigma must be positive. The best of the model's starts.
FamilyFit fitFamily(const ErrorModel& model, std::span<const ErrorPoint> points, int max_iterations);

// (JᵀWJ)⁻¹, row by row: the parameters' covariance for points that scatter by exactly their sigma. Parameters at a bound, and
// those that the points do not determine, are taken as fixed: their rows are 0 and determined[i] is false.
struct FamilyCovariance {
  std::vector<double> values;
  std::vector<bool> determined;
};
FamilyCovariance familyCovariance(const FamilyFit& fit, std::span<const ErrorPoint> points);

}  // namespace reprise
