#include "profiler/metrics/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "profiler/metrics/covered_pixels.h"
#include "profiler/metrics/flip_color.h"
#include "profiler/metrics/separable_filter.h"
#include "profiler/metrics/tiles.h"

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

constexpr std::array<float, 5> kExposures = {1, std::numbers::sqrt2_v<float>, 2, 2 * std::numbers::sqrt2_v<float>, 4};

Color exposed(const float* rgb, float exposure) {
  Color color{rgb[0], rgb[1], rgb[2]};
  if (exposure == 1) return color;
  for (float& channel : color) channel = std::min(1.0f, exposure * channel);
  return color;
}

// Of the image where the mask covers, or everywhere without one, and of the surroundings elsewhere.
OpponentImage opponentImage(const DisplayImage& image, const DisplayImage& surroundings, const CoverageMask* mask, float exposure) {
  const std::size_t pixels = image.rgb.size() / 3;
  OpponentImage planes;
  for (Plane& plane : planes) plane = {image.width, image.height, std::vector<float>(pixels)};
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* rgb = (mask == nullptr || mask->kind[i] ? image : surroundings).rgb.data() + 3 * i;
    // One that is not finite would spread to others.
    const Color color = ycxczFromSrgb(isFinite(rgb) ? exposed(rgb, exposure) : Color{0, 0, 0});
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

bool allFinite(const MetricInputs& inputs) {
  bool finite = true;
  visitCovered(*inputs.mask, [&](std::size_t i) {
    finite = finite && isFinite(inputs.original->rgb.data() + 3 * i) && isFinite(inputs.cached->rgb.data() + 3 * i);
  });
  return finite;
}

}  // namespace

struct FlipOriginal::Halves {
  const DisplayImage* original = nullptr;
  std::array<std::once_flag, kExposures.size()> made;
  std::array<PerceivedImage, kExposures.size()> perceived;

  const PerceivedImage& at(std::size_t exposure) {
    std::call_once(made[exposure], [&] { perceived[exposure] = perceive(opponentImage(*original, *original, nullptr, kExposures[exposure])); });
    return perceived[exposure];
  }
};

FlipOriginal::FlipOriginal(const DisplayImage& original) : halves_(std::make_unique<Halves>()) { halves_->original = &original; }
FlipOriginal::~FlipOriginal() = default;

namespace {

// FLIP of an image pair, at each exposure when it is first needed.
class FlipPair {
 public:
  explicit FlipPair(const MetricInputs& inputs) : inputs_(inputs) {
    if (inputs.flip_original == nullptr) own_.emplace(*inputs.original);
    halves_ = &(own_ ? *own_ : *inputs.flip_original).halves();
  }

  float differenceAt(std::size_t exposure, std::size_t pixel) {
    std::optional<PerceivedImage>& cached = cached_[exposure];
    if (!cached) cached = perceive(opponentImage(*inputs_.cached, *inputs_.original, inputs_.mask, kExposures[exposure]));
    return reprise::differenceAt(halves_->at(exposure), *cached, pixel);
  }

 private:
  const MetricInputs& inputs_;
  std::optional<FlipOriginal> own_;
  FlipOriginal::Halves* halves_ = nullptr;
  std::array<std::optional<PerceivedImage>, kExposures.size()> cached_;
};

double evaluate(const MetricInputs& inputs) {
  checkInputs(inputs);
  if (inputs.mask->kind.empty()) return 0;
  if (!allFinite(inputs)) return std::numeric_limits<double>::quiet_NaN();
  FlipPair pair(inputs);
  double sum = 0;
  const std::size_t covered = visitCovered(*inputs.mask, [&](std::size_t i) { sum += pair.differenceAt(0, i); });
  return covered ? sum / static_cast<double>(covered) : 0;
}

// The exposure nearest to the gain, by ratio.
std::size_t exposureOf(const Tile& tile) { return static_cast<std::size_t>(std::clamp(std::lround(2 * std::log2(tile.gain)), 0L, 4L)); }

std::vector<float> tilesOfFlip(const MetricInputs& inputs) {
  checkInputs(inputs);
  if (!allFinite(inputs)) return {std::numeric_limits<float>::quiet_NaN()};
  FlipPair pair(inputs);
  std::vector<float> values;
  for (const Tile& tile : tilesOf(inputs)) {
    float largest = 0;
    for (const std::size_t exposure : std::set<std::size_t>{0, exposureOf(tile)}) {
      float sum = 0;
      visitTile(tile, *inputs.mask, [&](std::size_t pixel) { sum += pair.differenceAt(exposure, pixel); });
      largest = std::max(largest, sum / static_cast<float>(tile.covered));
    }
    values.push_back(largest);
  }
  return values;
}

}  // namespace

Metric flipMetric() {
  return {.name = "flip",
          .description = "LDR-FLIP at 67 pixels per degree, mean over covered pixels",
          .combination = SessionCombination::kMean,
          .expensive = true,
          .evaluate = evaluate};
}

Metric tileFlipMetric() {
  return {.name = "tile_flip",
          .description = "LDR-FLIP at 67 pixels per degree, mean over a tile of 64x64 pixels, dark ones also at the exposure that brings them to mid-grey; 99th percentile over tiles",
          .combination = SessionCombination::kTail,
          .expensive = true,
          .adapts = true,
          .tiles = tilesOfFlip};
}

}  // namespace reprise
