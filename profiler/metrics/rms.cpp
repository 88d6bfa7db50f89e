#include "profiler/metrics/rms.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "profiler/metrics/covered_pixels.h"

namespace reprise {

namespace {

constexpr int kGroup = 4;             // pixels that are taken at once where the mask is the same for all
constexpr int kLanes = 3 * kGroup;    // independent sums, so that the compiler can vectorize without reordering
constexpr std::size_t kFlush = 2048;  // pixels after which single-precision sums go to double

struct SquareSum {
  double sum = 0;
  std::size_t covered = 0;
};

bool allCovered(const std::uint8_t* kind) {
  return (kind[0] != 0) & (kind[1] != 0) & (kind[2] != 0) & (kind[3] != 0);
}

bool noneCovered(const std::uint8_t* kind) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, kind, sizeof bits);
  return bits == 0;
}

void addGroup(const float* a, const float* b, float* lanes) {
  for (int lane = 0; lane < kLanes; ++lane) {
    const float difference = a[lane] - b[lane];
    lanes[lane] += difference * difference;
  }
}

void addPixel(const float* a, const float* b, SquareSum* total) {
  ++total->covered;
  for (int channel = 0; channel < 3; ++channel) {
    const double difference = static_cast<double>(a[channel]) - b[channel];
    total->sum += difference * difference;
  }
}

void addSpan(const float* a, const float* b, const std::uint8_t* kind, std::size_t pixels, SquareSum* total) {
  float lanes[kLanes] = {};
  std::size_t pixel = 0;
  for (; pixel + kGroup <= pixels; pixel += kGroup) {
    if (allCovered(kind + pixel)) {
      addGroup(a + 3 * pixel, b + 3 * pixel, lanes);
      total->covered += kGroup;
    } else if (!noneCovered(kind + pixel)) {
      for (std::size_t i = pixel; i < pixel + kGroup; ++i) {
        if (kind[i]) addPixel(a + 3 * i, b + 3 * i, total);
      }
    }
  }
  for (; pixel < pixels; ++pixel) {
    if (kind[pixel]) addPixel(a + 3 * pixel, b + 3 * pixel, total);
  }
  for (const float lane : lanes) total->sum += lane;
}

double evaluate(const MetricInputs& inputs) {
  checkInputs(inputs);
  const float* original = inputs.original->rgb.data();
  const float* cached = inputs.cached->rgb.data();
  const std::vector<std::uint8_t>& kind = inputs.mask->kind;
  SquareSum total;
  for (std::size_t first = 0; first < kind.size(); first += kFlush) {
    addSpan(original + 3 * first, cached + 3 * first, kind.data() + first, std::min(kFlush, kind.size() - first),
            &total);
  }
  return total.covered ? std::sqrt(total.sum / (3.0 * static_cast<double>(total.covered))) : 0;
}

}  // namespace

Metric rmsMetric() {
  return {.name = "rms",
          .description = "root of the mean squared difference over covered pixels and channels",
          .combination = SessionCombination::kRootMeanSquare,
          .evaluate = evaluate};
}

}  // namespace reprise
