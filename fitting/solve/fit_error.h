// Fits the error family of error_model.h to measured errors and picks a model.
//
// Weighted least squares by Levenberg-Marquardt (Ceres) with the parameters' bounds. A point weighs 1/s², where s is its sigma if
// given, else 5% (assumed_scatter) of its own error or of 1% of the largest: what counts is the relative deviation, for
// small errors too.
// The pick is by AICc = N ln(χ²/N) + 2k + 2k(k+1)/(N−k−1), k = parameters + 1, where N and χ² count the points and four more
// that scatter by exactly s. Six periods cannot show their own scatter: without the four, AICc prefers one parameter
// even where it misses by a third, and is not defined for few points. The intervals stand on the same scatter.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fitting/models/error_model.h"
#include "fitting/models/fit_verdict.h"

namespace reprise {

struct ErrorFitOptions {
  std::string family;        // fit this family only; empty: pick
  int max_iterations = 200;  // of the solver, per start
  double assumed_scatter = 0.05;  // relative, of points without a sigma
  double poor_scatter = 0.25;     // relative scatter above which the verdict is kPoor
};

struct FamilyScore {
  std::string family;
  double aicc = 0;       // smaller is better; comparable within one fit only
  double r_squared = 0;
  bool converged = false;
};

struct ErrorFit {
  std::string family;    // "constant" with a = 0 if every error was 0
  std::vector<FittedParameter> parameters;
  std::vector<double> covariance;  // of the parameters, row by row
  std::vector<double> residuals;   // measured − predicted, one per point used, by ascending period
  std::vector<ErrorPoint> points;  // used, by ascending period; sigma is the s that they were weighted by
  double scatter = 0;              // relative standard deviation of a point about the model, the four points counted
  double r_squared = 0;            // unweighted, against the mean; 1 if all points are met
  double aicc = 0;
  FitVerdict verdict = FitVerdict::kNoPoints;
  std::string explanation;         // of the verdict, one sentence
  std::vector<FamilyScore> families;  // all that were tried
};

// Points in any order; several may share a period. Period 1 and "never" (0) are left out, so are errors that are not finite or
// negative. Never fails: see the verdict. Deterministic.
ErrorFit fitErrorModel(std::span<const ErrorPoint> points, const ErrorFitOptions& options = {});

struct ErrorPrediction {
  double value = 0;       // in [0, 1], never falls with the period
  double lo = 0, hi = 0;  // 95%: uncertainty of the parameters and scatter of the points
};

// ε̂ at a period ≥ 1 (never has no prediction: 0 is refused by a check). All NaN if the fit is not usable.
ErrorPrediction predictError(const ErrorFit& fit, std::uint32_t period_frames);

}  // namespace reprise
