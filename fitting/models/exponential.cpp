#include "fitting/models/exponential.h"

#include <algorithm>
#include <cmath>

namespace reprise {

namespace {

// λ = 20 has saturated at n = 2 to within 2e-9: beyond it the model is the constant.
constexpr double kLeastRate = 1e-4, kMostRate = 20;

double shape(double rate, double period_frames) {
  return -std::expm1(-rate * (period_frames - 1));
}

double value(const double* parameters, double period_frames) {
  return parameters[0] * shape(parameters[1], period_frames);
}

void gradient(const double* parameters, double period_frames, double* derivatives) {
  const double age = period_frames - 1;
  derivatives[0] = shape(parameters[1], period_frames);
  derivatives[1] = parameters[0] * age * std::exp(-parameters[1] * age);
}

std::vector<std::vector<double>> starts(std::span<const ErrorPoint> points) {
  std::vector<std::vector<double>> result;
  for (const double rate : {0.003, 0.03, 0.3, 2.0}) {
    result.push_back({std::clamp(bestScale(points, shape, rate), 1e-9, 1.0), rate});
  }
  return result;
}

}  // namespace

const ErrorModel& exponentialErrorModel() {
  static const ErrorModel model = {"exponential",
                                   "alpha * (1 - exp(-lambda * (n - 1)))",
                                   {{"alpha", 0, 1}, {"lambda", kLeastRate, kMostRate}},
                                   value,
                                   gradient,
                                   starts};
  return model;
}

}  // namespace reprise
