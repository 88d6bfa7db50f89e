#include "fitting/models/constant.h"

#include <algorithm>

namespace reprise {

namespace {

// A period between 1 and 2 does not occur; the step lies right after 1.
double shape(double, double period_frames) {
  return period_frames > 1 ? 1 : 0;
}

double value(const double* parameters, double period_frames) {
  return parameters[0] * shape(0, period_frames);
}

void gradient(const double*, double period_frames, double* derivatives) {
  derivatives[0] = shape(0, period_frames);
}

std::vector<std::vector<double>> starts(std::span<const ErrorPoint> points) {
  return {{std::clamp(bestScale(points, shape, 0), 1e-9, 1.0)}};
}

}  // namespace

const ErrorModel& constantErrorModel() {
  static const ErrorModel model = {"constant", "a for n >= 2", {{"a", 0, 1}}, value, gradient, starts};
  return model;
}

}  // namespace reprise
