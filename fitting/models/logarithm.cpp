#include "fitting/models/logarithm.h"

#include <algorithm>
#include <cmath>

namespace reprise {

namespace {

double shape(double, double period_frames) {
  return std::log(period_frames);
}

double value(const double* parameters, double period_frames) {
  return parameters[0] * std::log(period_frames);
}

void gradient(const double*, double period_frames, double* derivatives) {
  derivatives[0] = std::log(period_frames);
}

std::vector<std::vector<double>> starts(std::span<const ErrorPoint> points) {
  return {{std::clamp(bestScale(points, shape, 0), 1e-9, 1.0)}};
}

}  // namespace

const ErrorModel& logarithmErrorModel() {
  static const ErrorModel model = {"logarithm", "a * ln(n)", {{"a", 0, 1}}, value, gradient, starts};
  return model;
}

}  // namespace reprise
