#include "fitting/models/error_model.h"

#include <algorithm>

namespace reprise {

double bestScale(std::span<const ErrorPoint> points, double (*shape)(double, double), double shape_parameter) {
  double projection = 0, norm = 0;
  for (const ErrorPoint& point : points) {
    if (!(point.error > 0)) continue;
    const double relative = shape(shape_parameter, point.period_frames) / point.error;
    projection += relative;
    norm += relative * relative;
  }
  return norm > 0 ? std::max(0.0, projection / norm) : 0;
}

}  // namespace reprise
