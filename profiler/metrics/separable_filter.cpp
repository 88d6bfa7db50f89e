#include "profiler/metrics/separable_filter.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/check.h"

namespace reprise {

namespace {

Plane filterRows(const Plane& in, const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  Plane out{in.width, in.height, std::vector<float>(in.values.size())};
  std::vector<float> padded(in.width + 2 * radius);
  for (int y = 0; y < in.height; ++y) {
    const float* row = in.values.data() + static_cast<std::size_t>(y) * in.width;
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, in.width, padded.begin() + radius);
    std::fill_n(padded.begin() + radius + in.width, radius, row[in.width - 1]);
    float* out_row = out.values.data() + static_cast<std::size_t>(y) * in.width;
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const float weight = kernel[k];
      const float* shifted = padded.data() + k;
      for (int x = 0; x < in.width; ++x) out_row[x] += weight * shifted[x];
    }
  }
  return out;
}

Plane filterColumns(const Plane& in, const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  Plane out{in.width, in.height, std::vector<float>(in.values.size())};
  for (int y = 0; y < in.height; ++y) {
    float* out_row = out.values.data() + static_cast<std::size_t>(y) * in.width;
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const int source = std::clamp(y + static_cast<int>(k) - radius, 0, in.height - 1);
      const float weight = kernel[k];
      const float* row = in.values.data() + static_cast<std::size_t>(source) * in.width;
      for (int x = 0; x < in.width; ++x) out_row[x] += weight * row[x];
    }
  }
  return out;
}

}  // namespace

Kernel gaussianKernel(double sigma, int radius) {
  REPRISE_CHECK(sigma > 0 && radius >= 0, sigma, radius);
  std::vector<double> weights;
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) {
    weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += weights.back();
  }
  Kernel kernel;
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

Plane filterPlane(const Plane& in, const Kernel& horizontal, const Kernel& vertical) {
  REPRISE_CHECK(in.width > 0 && in.height > 0, in.width, in.height);
  REPRISE_CHECK(horizontal.size() % 2 == 1 && vertical.size() % 2 == 1, horizontal.size(), vertical.size());
  return filterColumns(filterRows(in, horizontal), vertical);
}

}  // namespace reprise
