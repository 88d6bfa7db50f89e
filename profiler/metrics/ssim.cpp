#include "profiler/metrics/ssim.h"

#include "profiler/metrics/covered_pixels.h"
#include "profiler/metrics/separable_filter.h"

namespace reprise {

namespace {

constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

float lumaAt(const DisplayImage& image, std::size_t pixel) {
  const float* rgb = image.rgb.data() + 3 * pixel;
  return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
}

// Window sums over covered pixels of value(pixel).
template <typename Value>
Plane windowSums(const CoverageMask& mask, const Kernel& kernel, Value value) {
  Plane plane{mask.width, mask.height, std::vector<float>(mask.kind.size(), 0.0f)};
  visitCovered(mask, [&](std::size_t pixel) { plane.values[pixel] = value(pixel); });
  return filterPlane(plane, kernel, kernel);
}

double evaluate(const MetricInputs& inputs) {
  checkInputs(inputs);
  const CoverageMask& mask = *inputs.mask;
  if (mask.kind.empty()) return 0;
  const DisplayImage &original = *inputs.original, &cached = *inputs.cached;
  const Kernel kernel = gaussianKernel(1.5, 5);
  // Moments about 0.5 keep single precision from cancelling in the variances.
  const auto x = [&](std::size_t pixel) { return lumaAt(original, pixel) - 0.5f; };
  const auto y = [&](std::size_t pixel) { return lumaAt(cached, pixel) - 0.5f; };
  const Plane weight = windowSums(mask, kernel, [](std::size_t) { return 1.0f; });
  const Plane sum_x = windowSums(mask, kernel, x), sum_y = windowSums(mask, kernel, y);
  const Plane sum_xx = windowSums(mask, kernel, [&](std::size_t pixel) { return x(pixel) * x(pixel); });
  const Plane sum_yy = windowSums(mask, kernel, [&](std::size_t pixel) { return y(pixel) * y(pixel); });
  const Plane sum_xy = windowSums(mask, kernel, [&](std::size_t pixel) { return x(pixel) * y(pixel); });

  double total = 0;
  const std::size_t covered = visitCovered(mask, [&](std::size_t i) {
    const double w = weight.values[i];
    const double mean_x = sum_x.values[i] / w, mean_y = sum_y.values[i] / w;
    // Not cut at 0: rounding (far below C2) must be the same as the covariance's, so that identical images give exactly 1.
    const double variance_x = sum_xx.values[i] / w - mean_x * mean_x;
    const double variance_y = sum_yy.values[i] / w - mean_y * mean_y;
    const double covariance = sum_xy.values[i] / w - mean_x * mean_y;
    const double luma_x = mean_x + 0.5, luma_y = mean_y + 0.5;
    const double ssim = (2 * luma_x * luma_y + kC1) * (2 * covariance + kC2) /
                        ((luma_x * luma_x + luma_y * luma_y + kC1) * (variance_x + variance_y + kC2));
    total += ssim < 0 ? 1 : ssim > 1 ? 0 : 1 - ssim;  // NaN stays NaN
  });
  return covered ? total / static_cast<double>(covered) : 0;
}

}  // namespace

Metric ssimMetric() {
  return {.name = "ssim",
          .description = "1 - SSIM of luma with a Gaussian window of 11x11 pixels, mean over covered pixels",
          .combination = SessionCombination::kMean,
          .expensive = true,
          .evaluate = evaluate};
}

}  // namespace reprise
