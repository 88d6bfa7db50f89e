#include "fitting/models/power.h"

#include <algorithm>
#include <cmath>

namespace reprise {

namespace {

constexpr double kMostExponent = 3;

double shape(double exponent, double period_frames) {
  return period_frames <= 1 ? 0 : std::pow(period_frames - 1, exponent);
}

double value(const double* parameters, double period_frames) {
  return parameters[0] * shape(parameters[1], period_frames);
}

void gradient(const double* parameters, double period_frames, double* derivatives) {
  derivatives[0] = shape(parameters[1], period_frames);
  derivatives[1] = period_frames <= 1 ? 0 : parameters[0] * derivatives[0] * std::log(period_frames - 1);
}

std::vector<std::vector<double>> starts(std::span<const ErrorPoint> points) {
  std::vector<std::vector<double>> result;
  for (const double exponent : {0.1, 0.4, 1.0}) {
    result.push_back({std::clamp(bestScale(points, shape, exponent), 1e-9, 1.0), exponent});
  }
  return result;
}

}  // namespace

const ErrorModel& powerErrorModel() {
  static const ErrorModel model = {"power", "a * (n - 1)^p", {{"a", 0, 1}, {"p", 0, kMostExponent}},
                                   value,   gradient,        starts};
  return model;
}

}  // namespace reprise
