// What holds for every metric of the registry, and known values of each.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "profiler/metrics/metrics.h"
#include "tests/metrics/test_images.h"

namespace reprise {
namespace {

double evaluate(const std::string& name, const DisplayImage& original, const DisplayImage& cached,
                const CoverageMask& mask) {
  return findMetric(name)->value({&original, &cached, nullptr, nullptr, &mask});
}

// With the same image before: a difference that has just appeared.
double evaluateAfterEqualFrame(const Metric& metric, const DisplayImage& original, const DisplayImage& cached,
                               const CoverageMask& mask) {
  const std::vector<std::uint8_t> ages = blockAges(mask.width, mask.height);
  return metric.value({&original, &cached, &original, &original, &mask, &ages});
}

CoverageMask randomMask(int width, int height, std::uint32_t seed) {
  CoverageMask mask = fullMask(width, height);
  std::mt19937 random(seed);
  for (std::uint8_t& kind : mask.kind) kind = static_cast<std::uint8_t>(random() % 3);
  mask.kind[0] = 1;
  return mask;
}

TEST(Metrics, RegistryHoldsEveryMetricOnceAndFindsItByName) {
  std::set<std::string> names;
  for (const Metric& metric : metrics()) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_EQ(findMetric(metric.name), &metric);
    EXPECT_FALSE(metric.description.empty()) << metric.name;
  }
  EXPECT_EQ(names, (std::set<std::string>{"blocks", "flicker", "flip", "largest", "mean", "over8", "p95", "relative_rms", "rms", "ssim", "tile_flicker", "tile_flip",
                                         "tile_rms"}));
  EXPECT_EQ(findMetric("psnr"), nullptr);
}

RC_GTEST_PROP(Metrics, AreZeroForIdenticalImages, ()) {
  const int width = *rc::gen::inRange(1, 40), height = *rc::gen::inRange(1, 40);
  const auto seed = *rc::gen::inRange<std::uint32_t>(0, 1000);
  const DisplayImage image = withNoise(smoothImage(width, height), 0.25f, seed);
  const CoverageMask mask = randomMask(width, height, seed);
  for (const Metric& metric : metrics()) {
    RC_ASSERT(evaluateAfterEqualFrame(metric, image, image, mask) == 0.0);
  }
}

RC_GTEST_PROP(Metrics, LieInTheUnitInterval, ()) {
  const int width = *rc::gen::inRange(1, 30), height = *rc::gen::inRange(1, 30);
  const auto seed = *rc::gen::inRange<std::uint32_t>(0, 1000);
  // Full-range noise in all four images: flicker's difference can change by 2.
  const DisplayImage gray = flatImage(width, height, 0.5f);
  const DisplayImage a = withNoise(gray, 2, seed), b = withNoise(gray, 2, seed + 1);
  const DisplayImage c = withNoise(gray, 2, seed + 2), d = withNoise(gray, 2, seed + 3);
  const CoverageMask mask = randomMask(width, height, seed);
  for (const Metric& metric : metrics()) {
    const std::vector<std::uint8_t> ages = blockAges(width, height);
    const double value = metric.value({&a, &b, &c, &d, &mask, &ages});
    RC_ASSERT(value >= 0.0);
    RC_ASSERT(value <= 1.0);
  }
}

TEST(Metrics, GrowWithNoise) {
  const DisplayImage image = smoothImage(48, 40);
  const CoverageMask mask = fullMask(48, 40);
  for (const Metric& metric : metrics()) {
    if (metric.name == "blocks") continue;  // noise does not follow ages: tiles_test.cpp
    double last = 0;
    for (const float amplitude : {0.04f, 0.08f, 0.16f, 0.25f}) {
      const double value = evaluateAfterEqualFrame(metric, image, withNoise(image, amplitude, 7), mask);
      EXPECT_GT(value, last) << metric.name << " at " << amplitude;
      last = value;
    }
  }
}

TEST(Metrics, AreSymmetric) {
  // What is not covered is the same in both, as it is in frames of the original and of a variant.
  const DisplayImage a = smoothImage(33, 21);
  DisplayImage b = withNoise(a, 0.2f, 3);
  const CoverageMask mask = randomMask(33, 21, 5);
  for (std::size_t i = 0; i < b.rgb.size(); ++i) {
    if (!mask.kind[i / 3]) b.rgb[i] = a.rgb[i];
  }
  for (const Metric& metric : metrics()) {
    if (metric.adapts) continue;
    EXPECT_NEAR(evaluateAfterEqualFrame(metric, a, b, mask), metric.value({&b, &a, &a, &a, &mask}), 1e-6)
        << metric.name;
  }
}

TEST(Metrics, DoNotSeeUncoveredPixels) {
  constexpr int kWidth = 64, kHeight = 16, kCovered = 24;
  const DisplayImage image = smoothImage(kWidth, kHeight);
  DisplayImage changed = image, broken = image;
  CoverageMask mask = fullMask(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = kCovered; x < kWidth; ++x) {
      mask.kind[y * kWidth + x] = 0;
      changed.rgb[3 * (y * kWidth + x)] = 0;
      broken.rgb[3 * (y * kWidth + x) + 1] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  const CoverageMask everything = fullMask(kWidth, kHeight);
  for (const Metric& metric : metrics()) {
    EXPECT_NEAR(evaluateAfterEqualFrame(metric, image, changed, mask), 0, 1e-6) << metric.name;
    EXPECT_NEAR(evaluateAfterEqualFrame(metric, image, broken, mask), 0, 1e-6) << metric.name;
    EXPECT_NEAR(evaluateAfterEqualFrame(metric, broken, broken, mask), 0, 1e-6) << metric.name;
    EXPECT_GT(evaluateAfterEqualFrame(metric, image, changed, everything), 0.001) << metric.name;
  }
}

TEST(Metrics, GiveZeroWithoutCoveredPixels) {
  const DisplayImage black = flatImage(8, 8, 0), white = flatImage(8, 8, 1);
  CoverageMask mask = fullMask(8, 8);
  mask.kind.assign(mask.kind.size(), 0);
  for (const Metric& metric : metrics()) {
    EXPECT_EQ(evaluateAfterEqualFrame(metric, black, white, mask), 0) << metric.name;
  }
}

TEST(Metrics, ShowNanInsteadOfAveragingItAway) {
  const DisplayImage image = smoothImage(16, 16);
  for (int channel = 0; channel < 3; ++channel) {
    DisplayImage bad = image;
    bad.rgb[3 * 100 + channel] = std::numeric_limits<float>::quiet_NaN();
    for (const Metric& metric : metrics()) {
      EXPECT_TRUE(std::isnan(evaluateAfterEqualFrame(metric, image, bad, fullMask(16, 16)))) << metric.name << channel;
    }
  }
}

TEST(Rms, IsTheRootOfTheMeanSquaredDifference) {
  const CoverageMask mask = fullMask(13, 7);
  EXPECT_NEAR(evaluate("rms", flatImage(13, 7, 0.25f), flatImage(13, 7, 0.35f), mask), 0.1, 1e-6);
  DisplayImage one_channel = flatImage(13, 7, 0.25f);
  for (std::size_t i = 1; i < one_channel.rgb.size(); i += 3) one_channel.rgb[i] += 0.3f;
  EXPECT_NEAR(evaluate("rms", flatImage(13, 7, 0.25f), one_channel, mask), 0.3 / std::sqrt(3.0), 1e-6);
}

RC_GTEST_PROP(Rms, EqualsThePlainSumWhateverTheMask, ()) {
  const int width = *rc::gen::inRange(1, 200), height = *rc::gen::inRange(1, 40);
  const auto seed = *rc::gen::inRange<std::uint32_t>(0, 1000);
  const DisplayImage a = smoothImage(width, height), b = withNoise(a, 0.2f, seed);
  CoverageMask mask = randomMask(width, height, seed);
  // Whole runs of covered and of uncovered pixels beside mixed ones.
  for (std::size_t i = 0; i < mask.kind.size(); ++i) {
    if (i / 16 % 3 != 2) mask.kind[i] = static_cast<std::uint8_t>(i / 16 % 3);
  }
  double sum = 0;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    if (!mask.kind[i / 3]) continue;
    covered += i % 3 == 0;
    sum += (static_cast<double>(a.rgb[i]) - b.rgb[i]) * (static_cast<double>(a.rgb[i]) - b.rgb[i]);
  }
  const double expected = covered ? std::sqrt(sum / (3.0 * static_cast<double>(covered))) : 0;
  RC_ASSERT(std::abs(evaluate("rms", a, b, mask) - expected) <= 1e-6 * expected);
}

TEST(MeanDifference, IsTheMeanOfMagnitudes) {
  DisplayImage cached = flatImage(4, 4, 0.5f);
  for (std::size_t i = 0; i < cached.rgb.size(); ++i) cached.rgb[i] += i % 2 ? 0.2f : -0.1f;
  EXPECT_NEAR(evaluate("mean", flatImage(4, 4, 0.5f), cached, fullMask(4, 4)), 0.15, 1e-6);
}

TEST(P95, IsThePixelThatFivePercentExceed) {
  DisplayImage cached = flatImage(10, 10, 0);
  for (int pixel = 0; pixel < 100; ++pixel) {
    for (int channel = 0; channel < 3; ++channel) cached.rgb[3 * pixel + channel] = 0.01f * ((pixel * 37) % 100);
  }
  EXPECT_NEAR(evaluate("p95", flatImage(10, 10, 0), cached, fullMask(10, 10)), 0.94, 1e-6);
}

TEST(Over8, CountsPixelsAboveTheThresholdOnly) {
  DisplayImage cached = flatImage(4, 1, 0);
  cached.rgb[3 * 0 + 1] = 9.0f / 255;
  cached.rgb[3 * 1 + 2] = 8.0f / 255;
  for (int channel = 0; channel < 3; ++channel) cached.rgb[3 * 2 + channel] = 7.0f / 255;
  EXPECT_NEAR(evaluate("over8", flatImage(4, 1, 0), cached, fullMask(4, 1)), 0.25, 1e-9);
}

TEST(Flicker, SeesChangesOfTheDifferenceNotTheDifference) {
  const DisplayImage before = flatImage(6, 6, 0.2f), after = flatImage(6, 6, 0.4f);
  const DisplayImage before_off = flatImage(6, 6, 0.3f), after_off = flatImage(6, 6, 0.5f);
  const CoverageMask mask = fullMask(6, 6);
  const Metric& flicker = *findMetric("flicker");
  EXPECT_NEAR(flicker.value({&after, &after_off, &before, &before_off, &mask}), 0, 1e-6);
  EXPECT_NEAR(flicker.value({&after, &after, &before, &before_off, &mask}), 0.1, 1e-6);
  EXPECT_EQ(flicker.value({&after, &after_off, nullptr, nullptr, &mask}), 0);
}

TEST(Ssim, OfFlatImagesIsItsLuminanceTerm) {
  const double a = 0.2, b = 0.6, c1 = 0.01 * 0.01;
  const double expected = 1 - (2 * a * b + c1) / (a * a + b * b + c1);
  EXPECT_NEAR(evaluate("ssim", flatImage(20, 20, 0.2f), flatImage(20, 20, 0.6f), fullMask(20, 20)), expected, 1e-4);
}

RC_GTEST_PROP(P95, EqualsTheSortedValueOfNearestRank, ()) {
  const int width = *rc::gen::inRange(1, 60), height = *rc::gen::inRange(1, 60);
  const auto seed = *rc::gen::inRange<std::uint32_t>(0, 1000);
  const DisplayImage a = smoothImage(width, height), b = withNoise(a, 0.2f, seed);
  const CoverageMask mask = randomMask(width, height, seed);
  std::vector<double> differences;
  for (std::size_t i = 0; i < mask.kind.size(); ++i) {
    if (!mask.kind[i]) continue;
    double sum = 0;
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) sum += std::abs(static_cast<double>(a.rgb[k]) - b.rgb[k]);
    differences.push_back(sum / 3);
  }
  std::sort(differences.begin(), differences.end());
  const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(differences.size()) - 1e-9));
  RC_ASSERT(std::abs(evaluate("p95", a, b, mask) - differences[rank - 1]) < 1e-6);
}

TEST(P95, AveragesTheMagnitudesOfTheChannels) {
  DisplayImage cached = flatImage(5, 5, 0.5f);
  for (std::size_t i = 0; i < cached.rgb.size(); i += 3) {
    cached.rgb[i] += 0.3f;
    cached.rgb[i + 1] -= 0.15f;
  }
  EXPECT_NEAR(evaluate("p95", flatImage(5, 5, 0.5f), cached, fullMask(5, 5)), 0.15, 1e-6);
}

// Flat images have no features and pass the filters unchanged, so that the colour difference alone remains: the pair of
// greatest distance, green and blue, gives 1, and grays follow from L* = 116 Y^(1/3) − 16.
TEST(Flip, OfFlatImagesIsTheirRedistributedColorDistance) {
  const CoverageMask mask = fullMask(24, 24);
  DisplayImage green = flatImage(24, 24, 0), blue = green;
  for (std::size_t i = 0; i < green.rgb.size(); i += 3) green.rgb[i + 1] = blue.rgb[i + 2] = 1;
  EXPECT_NEAR(evaluate("flip", green, blue, mask), 1, 1e-4);

  // sRGB 0.5 is Y = 0.214041, L* = 53.3890; 0.6 is Y = 0.318547, L* = 63.2226. Green and blue, the largest distance of
  // the space after the Hunt adjustment, lie 203.3 apart.
  const double distance = std::pow(63.2226 - 53.3890, 0.7);
  const double largest = std::pow(203.3, 0.7);
  EXPECT_NEAR(evaluate("flip", flatImage(24, 24, 0.5f), flatImage(24, 24, 0.6f), mask),
              0.95 * distance / (0.4 * largest), 1e-3);
}

TEST(CombineFrames, WeighsByCoveredPixels) {
  const std::vector<MetricFrame> frames = {{0.1, 300}, {0.3, 100}, {0.9, 0}};
  EXPECT_NEAR(combineFrames(*findMetric("rms"), frames), std::sqrt((3 * 0.01 + 0.09) / 4), 1e-12);
  EXPECT_NEAR(combineFrames(*findMetric("mean"), frames), 0.15, 1e-12);
  EXPECT_NEAR(combineFrames(*findMetric("p95"), frames), 0.2, 1e-12);
  EXPECT_NEAR(combineFrames(*findMetric("largest"), frames), 0.3, 1e-12);
}

// One bad tile of 101 in all does not decide, two do.
TEST(CombineFrames, TakesThe99thPercentileOverAllTiles) {
  std::vector<std::uint16_t> calm(60, 655), bad(41, 655);
  bad[7] = 65535;
  const std::vector<MetricFrame> frames = {{0.01, 100, &calm}, {1, 100, &bad}};
  EXPECT_NEAR(combineFrames(*findMetric("tile_rms"), frames), 0.01, 1e-4);
  bad[8] = 32768;
  EXPECT_NEAR(combineFrames(*findMetric("tile_rms"), frames), 0.5, 1e-4);
}

TEST(CombineFrames, IsNanWithoutCoveredPixels) {
  for (const Metric& metric : metrics()) {
    EXPECT_TRUE(std::isnan(combineFrames(metric, std::vector<MetricFrame>{{0.1, 0}, {0.2, 0}})));
    EXPECT_TRUE(std::isnan(combineFrames(metric, {})));
  }
}

TEST(CombineFrames, OfRmsEqualsTheRmsOfAllPixels) {
  // Two frames of different coverage against one tall frame that holds both.
  const DisplayImage a = flatImage(4, 4, 0), b = flatImage(4, 4, 0.2f), c = flatImage(4, 4, 0.5f);
  CoverageMask half = fullMask(4, 4);
  for (std::size_t i = 0; i < 8; ++i) half.kind[i] = 0;
  const std::vector<MetricFrame> frames = {{evaluate("rms", a, b, fullMask(4, 4)), 16}, {evaluate("rms", a, c, half), 8}};
  const double expected = std::sqrt((16 * 0.04 + 8 * 0.25) / 24);
  EXPECT_NEAR(combineFrames(*findMetric("rms"), frames), expected, 1e-6);
}

}  // namespace
}  // namespace reprise
