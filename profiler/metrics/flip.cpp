#include "profiler/metrics/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "profiler/metrics/covered_pixels.h"
#include "profiler/metrics/flip_color.h"
#include "profiler/metrics/separable_filter.h"

namespace reprise {

namespace {

constexpr double kPi = std::numbers::pi;
// Distance × pixels per metre × π / 180.
constexpr double kPixelsPerDegree = 0.7 * (3840 / 0.7) * (kPi / 180);
constexpr float kColorExponent = 0.7f, kFeatureExponent = 0.5f;
constexpr float kSplit = 0.4f, kSplitValue = 0.95f;  // p_c and p_t: the share of the range mapped to [0, 0.95]
constexpr double kFeatureWidthDegrees = 0.082;

// exp(−π² x² / b), x in degrees, is a Gaussian of this many pixels.
double sigmaOfScale(double b) {
  return std::sqrt(b / 2) / kPi * kPixelsPerDegree;
}

// A contrast sensitivity function Σ a √(π/b) exp(−π² (x² + y²) / b), normalized, as a sum of separable Gaussians.
struct SensitivityFilter {
  std::vector<Kernel> kernels;
  std::vector<float> shares;  // sum to 1
};

SensitivityFilter sensitivityFilter(std::vector<std::pair<double, double>> amplitudes_and_scales) {
  const int radius = static_cast<int>(std::ceil(3 * sigmaOfScale(0.04)));
  SensitivityFilter filter;
  std::vector<double> volumes;
  double total = 0;
  for (const auto& [amplitude, scale] : amplitudes_and_scales) {
    const double sigma = sigmaOfScale(scale);
    double line = 0;
    for (int i = -radius; i <= radius; ++i) line += std::exp(-0.5 * i * i / (sigma * sigma));
    volumes.push_back(amplitude * std::sqrt(kPi / scale) * line * line);
    total += volumes.back();
    filter.kernels.push_back(gaussianKernel(sigma, radius));
  }
  for (const double volume : volumes) filter.shares.push_back(static_cast<float>(volume / total));
  return filter;
}

const std::array<SensitivityFilter, 3>& sensitivityFilters() {
  static const std::array<SensitivityFilter, 3> filters = {
      sensitivityFilter({{1, 0.0047}}), sensitivityFilter({{1, 0.0053}}),
      sensitivityFilter({{34.1, 0.04}, {13.5, 0.025}})};
  return filters;
}

bool isFinite(const float* rgb) {
  return std::isfinite(rgb[0]) && std::isfinite(rgb[1]) && std::isfinite(rgb[2]);
}

using OpponentImage = std::array<Plane, 3>;

// Of the image where the mask covers and of the surroundings elsewhere.
OpponentImage opponentImage(const DisplayImage& image, const DisplayImage& surroundings, const CoverageMask& mask) {
  const std::size_t pixels = mask.kind.size();
  OpponentImage planes;
  for (Plane& plane : planes) plane = {image.width, image.height, std::vector<float>(pixels)};
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* rgb = (mask.kind[i] ? image : surroundings).rgb.data() + 3 * i;
    Color color = ycxczFromSrgb({rgb[0], rgb[1], rgb[2]});
    // One that is not finite would spread to covered pixels.
    if (!mask.kind[i] && !isFinite(rgb)) color = ycxczFromSrgb({0, 0, 0});
    for (int channel = 0; channel < 3; ++channel) planes[channel].values[i] = color[channel];
  }
  return planes;
}

Plane applyFilter(const Plane& in, const SensitivityFilter& filter) {
  Plane sum{in.width, in.height, std::vector<float>(in.values.size(), 0.0f)};
  for (std::size_t k = 0; k < filter.kernels.size(); ++k) {
    const Plane part = filterPlane(in, filter.kernels[k], filter.kernels[k]);
    for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += filter.shares[k] * part.values[i];
  }
  return sum;
}

// What the eye resolves, in the space that colours are compared in.
std::vector<Color> perceivedColors(const OpponentImage& image) {
  OpponentImage filtered;
  for (int channel = 0; channel < 3; ++channel) {
    filtered[channel] = applyFilter(image[channel], sensitivityFilters()[channel]);
  }
  std::vector<Color> colors(filtered[0].values.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    colors[i] = huntLabFromRgb(
        clampedRgbFromYcxcz({filtered[0].values[i], filtered[1].values[i], filtered[2].values[i]}));
  }
  return colors;
}

float colorDifference(const Color& first, const Color& second) {
  static const float largest =
      std::pow(hyabDistance(huntLabFromRgb({0, 1, 0}), huntLabFromRgb({0, 0, 1})), kColorExponent);
  const float difference = std::pow(hyabDistance(first, second), kColorExponent);
  const float split = kSplit * largest;
  if (difference < split) return difference * kSplitValue / split;
  return kSplitValue + (difference - split) / (largest - split) * (1 - kSplitValue);
}

// Scales positive weights to sum to 1 and negative ones to −1.
Kernel balanced(const std::vector<double>& weights) {
  double positive = 0, negative = 0;
  for (const double weight : weights) (weight > 0 ? positive : negative) += std::abs(weight);
  Kernel kernel;
  for (const double weight : weights) {
    kernel.push_back(static_cast<float>(weight > 0 ? weight / positive : weight < 0 ? weight / negative : 0));
  }
  return kernel;
}

struct FeatureKernels {
  Kernel smooth, edge, point;  // a Gaussian, its first and its second derivative
};

const FeatureKernels& featureKernels() {
  static const FeatureKernels kernels = [] {
    const double sigma = 0.5 * kFeatureWidthDegrees * kPixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    std::vector<double> edge, point;
    for (int x = -radius; x <= radius; ++x) {
      const double gaussian = std::exp(-0.5 * x * x / (sigma * sigma));
      edge.push_back(-x * gaussian);
      point.push_back((x * x / (sigma * sigma) - 1) * gaussian);
    }
    return FeatureKernels{gaussianKernel(sigma, radius), balanced(edge), balanced(point)};
  }();
  return kernels;
}

// Magnitude of the response to a derivative kernel along both axes.
Plane featureStrength(const Plane& luminance, const Kernel& derivative) {
  const Kernel& smooth = featureKernels().smooth;
  Plane strength = filterPlane(luminance, derivative, smooth);
  const Plane vertical = filterPlane(luminance, smooth, derivative);
  for (std::size_t i = 0; i < strength.values.size(); ++i) {
    strength.values[i] = std::hypot(strength.values[i], vertical.values[i]);
  }
  return strength;
}

Plane normalizedLuminance(const Plane& y) {
  Plane luminance = y;
  for (float& value : luminance.values) value = (value + 16) / 116;
  return luminance;
}

struct PerceivedImage {
  std::vector<Color> colors;
  Plane edges, points;
};

PerceivedImage perceive(const OpponentImage& image) {
  const Plane luminance = normalizedLuminance(image[0]);
  return {perceivedColors(image), featureStrength(luminance, featureKernels().edge),
          featureStrength(luminance, featureKernels().point)};
}

float differenceAt(const PerceivedImage& first, const PerceivedImage& second, std::size_t i) {
  const float edge = std::abs(first.edges.values[i] - second.edges.values[i]);
  const float point = std::abs(first.points.values[i] - second.points.values[i]);
  const float feature =
      std::min(1.0f, std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, kFeatureExponent));
  const float color = std::min(1.0f, colorDifference(first.colors[i], second.colors[i]));
  return std::pow(color, 1 - feature);
}

double evaluate(const MetricInputs& inputs) {
  checkInputs(inputs);
  const CoverageMask& mask = *inputs.mask;
  if (mask.kind.empty()) return 0;
  const PerceivedImage original = perceive(opponentImage(*inputs.original, *inputs.original, mask));
  const PerceivedImage cached = perceive(opponentImage(*inputs.cached, *inputs.original, mask));
  double sum = 0;
  bool finite = true;
  const std::size_t covered = visitCovered(mask, [&](std::size_t i) {
    finite = finite && isFinite(inputs.original->rgb.data() + 3 * i) && isFinite(inputs.cached->rgb.data() + 3 * i);
    sum += differenceAt(original, cached, i);
  });
  if (!finite) return std::numeric_limits<double>::quiet_NaN();
  return covered ? sum / static_cast<double>(covered) : 0;
}

}  // namespace

Metric flipMetric() {
  return {"flip", "LDR-FLIP at 67 pixels per degree, mean over covered pixels", SessionCombination::kMean, true,
          evaluate};
}

}  // namespace reprise
