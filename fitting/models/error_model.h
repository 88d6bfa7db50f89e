// The family of error models: how the error of reusing a payload grows with the refresh period n (frames).
//
//   exponential  ε̂(n) = α (1 − e^(−λ(n−1)))   Eq. 4 of the survey (section 4.1; Sitthi-amorn et al. 2008); 0 ≤ α ≤ 1, λ ≥ 0
//   power        ε̂(n) = a (n−1)^p             a, p ≥ 0; measured: repeated bilinear resampling, p = 0.3 to 0.4
//   logarithm    ε̂(n) = a ln n                a ≥ 0; one parameter on purpose: a ln(1 + b(n−1)) differs from its neighbours
//                                             only where b is extreme, and six periods cannot pin b down
//   constant     ε̂(n) = a for n ≥ 2           a ≥ 0; errors that do not age: encodings, key frames
//
// All are 0 at n = 1 (always refreshed), never fall with n, and are in the unit of the metric: [0, 1], 0 = identical.
// Known to be wrong: Eq. 4 where errors keep growing (bilinear, n > 32); all of them where the input is periodic with a
// period near n, and for "never", which has no n: it is measured and stays outside the fit.
//
// A new model is one file pair, one line in registry.cpp; tests/fitting iterates over errorModels().
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace reprise {

// One measured error. sigma is its standard deviation where known (over sessions, say), else 0.
struct ErrorPoint {
  std::uint32_t period_frames = 1;
  double error = 0;
  double sigma = 0;
};

struct ModelParameter {
  const char* name = "";
  double lower = 0, upper = 0;
};

struct ErrorModel {
  const char* name = "";  // "exponential", "power", "logarithm", "constant"
  const char* formula = "";
  std::vector<ModelParameter> parameters;
  // ε̂(n) for n ≥ 1; 0 at n = 1.
  double (*value)(const double* parameters, double period_frames) = nullptr;
  // ∂ε̂/∂parameter, one number per parameter.
  void (*gradient)(const double* parameters, double period_frames, double* derivatives) = nullptr;
  // Parameter vectors from which a solver should start, the first that converges best wins.
  std::vector<std::vector<double>> (*starts)(std::span<const ErrorPoint> points) = nullptr;
};

// The registry, an explicit table. Where two models explain the points equally well the earlier entry is taken.
std::span<const ErrorModel> errorModels();
const ErrorModel* findErrorModel(const std::string& name);

// The a ≥ 0 that minimizes Σ (a shape(n_i) − ε_i)² / ε_i² over the points: for the starts of models of the form a·shape(n).
double bestScale(std::span<const ErrorPoint> points, double (*shape)(double shape_parameter, double period_frames),
                 double shape_parameter);

}  // namespace reprise
