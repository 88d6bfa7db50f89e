// FLIP against values of a direct evaluation of the paper's formulas: two-dimensional filters summed tap by tap in double
// precision, where the metric uses separable filters in single precision.
#include <gtest/gtest.h>

#include <cmath>

#include "profiler/metrics/metrics.h"
#include "tests/metrics/test_images.h"

namespace reprise {
namespace {

constexpr int kWidth = 24, kHeight = 16;

// Waves and a ramp; the cached image is shifted a little and has a red rectangle in it.
DisplayImage waves(bool cached) {
  DisplayImage image = flatImage(kWidth, kHeight, 0);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double ramp = x / 24.0;
      double rgb[3] = {0.5 + 0.4 * std::sin(0.3 * x + (cached ? 0.2 : 0)) * std::cos(0.2 * y),
                       cached ? 0.9 * ramp + 0.02 : ramp,
                       0.5 + 0.5 * std::cos(0.11 * x + 0.23 * y + (cached ? 0.1 : 0))};
      if (cached && x >= 10 && x < 18 && y >= 5 && y < 11) rgb[0] = 0.9, rgb[1] = 0.1, rgb[2] = 0.2;
      for (int channel = 0; channel < 3; ++channel) {
        image.rgb[3 * (y * kWidth + x) + channel] = static_cast<float>(rgb[channel]);
      }
    }
  }
  return image;
}

double flip(const DisplayImage& original, const DisplayImage& cached, const CoverageMask& mask) {
  return findMetric("flip")->value({&original, &cached, nullptr, nullptr, &mask});
}

TEST(Flip, EqualsADirectEvaluationOfThePaper) {
  EXPECT_NEAR(flip(waves(false), waves(true), fullMask(kWidth, kHeight)), 0.379814, 2e-4);
}

// Outside the mask both images show the original there, also to the filters.
TEST(Flip, AveragesOverTheMaskAndTakesTheOriginalOutsideIt) {
  CoverageMask left = fullMask(kWidth, kHeight), rectangle = left;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const int x = i % kWidth, y = i / kWidth;
    left.kind[i] = x < 12;
    rectangle.kind[i] = x >= 8 && x < 16 && y >= 4 && y < 10;
  }
  EXPECT_NEAR(flip(waves(false), waves(true), left), 0.191904, 2e-4);
  EXPECT_NEAR(flip(waves(false), waves(true), rectangle), 0.596349, 2e-4);
}

TEST(Flip, OfBlackAndWhiteIsNearlyOne) {
  EXPECT_NEAR(flip(flatImage(16, 16, 0), flatImage(16, 16, 1), fullMask(16, 16)), 0.967380, 1e-4);
}

}  // namespace
}  // namespace reprise
