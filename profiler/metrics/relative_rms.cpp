#include "profiler/metrics/relative_rms.h"

#include "profiler/metrics/covered_pixels.h"
#include "profiler/metrics/rms.h"

namespace reprise {
namespace {

double evaluate(const MetricInputs& inputs) {
  static const Metric rms = rmsMetric();
  const double error = rms.evaluate(inputs);
  if (error == 0) return 0;
  const float* original = inputs.original->rgb.data();
  double luminance = 0;
  const std::size_t covered = visitCovered(*inputs.mask, [&](std::size_t pixel) {
    const float* rgb = original + 3 * pixel;
    luminance += static_cast<double>(0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2]);
  });
  const double share = error * static_cast<double>(covered) / luminance;
  return share > 1 ? 1 : share;  // NaN stays NaN
}

}  // namespace

Metric relativeRmsMetric() {
  return {.name = "relative_rms",
          .description = "rms over the mean luminance of the original's covered pixels",
          .combination = SessionCombination::kRootMeanSquare,
          .adapts = true,
          .evaluate = evaluate};
}

}  // namespace reprise
