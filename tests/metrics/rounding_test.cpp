// The rule of rounding, value by value and image by image.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "profiler/metrics/rounding.h"

namespace reprise {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

using Words = std::vector<std::uint32_t>;

// Pixels whose other channels are 0.
Words floats(const std::vector<float>& values) {
  Words words;
  for (const float value : values) words.insert(words.end(), {std::bit_cast<std::uint32_t>(value), 0, 0, 0});
  return words;
}

Words steps(std::size_t pixels, std::uint32_t value) { return Words(pixels * 4, value); }

struct Case {
  const char* name;
  float expected, found;
  Difference difference;
};

class FloatRounding : public testing::TestWithParam<Case> {};

TEST_P(FloatRounding, IsToldFromMore) {
  const Words expected = floats({0.5f, GetParam().expected}), found = floats({0.5f, GetParam().found});
  const RoundingVerdict verdict = compareImages({expected, found, TexelKind::kFloat});
  EXPECT_EQ(verdict.difference, GetParam().difference);
  EXPECT_EQ(verdict.differing, GetParam().difference == Difference::kNone ? 0u : 1u);
  EXPECT_EQ(verdict.beyond, GetParam().difference == Difference::kBeyondRounding ? 1u : 0u);
  EXPECT_EQ(verdict.pixel, GetParam().difference == Difference::kNone ? 0u : 1u);
}

INSTANTIATE_TEST_SUITE_P(Values, FloatRounding,
                         testing::Values(Case{"same", 0.25f, 0.25f, Difference::kNone}, Case{"zeros", 0.0f, -0.0f, Difference::kNone},
                                         Case{"not_numbers", kNaN, -kNaN, Difference::kNone}, Case{"infinities", kInfinity, kInfinity, Difference::kNone},
                                         Case{"one_unit_in_the_last_place", 0.25f, std::nextafter(0.25f, 1.0f), Difference::kRounding},
                                         Case{"near_zero", 0.0f, 0.9e-5f, Difference::kRounding}, Case{"too_far_from_zero", 0.0f, 1.1e-5f, Difference::kBeyondRounding},
                                         Case{"large", 1000.0f, 1000.009f, Difference::kRounding}, Case{"too_far_from_large", 1000.0f, 1000.011f, Difference::kBeyondRounding},
                                         Case{"other_sign", 0.5f, -0.5f, Difference::kBeyondRounding}, Case{"opposite_infinities", kInfinity, -kInfinity, Difference::kBeyondRounding},
                                         Case{"no_number_any_more", 1.0f, kNaN, Difference::kBeyondRounding}, Case{"a_number_after_all", kNaN, 1.0f, Difference::kBeyondRounding},
                                         Case{"infinite", 3e38f, kInfinity, Difference::kBeyondRounding}),
                         [](const testing::TestParamInfo<Case>& one) { return one.param.name; });

TEST(Rounding, TellsThePixelThatIsOffMostForItsSize) {
  const RoundingVerdict verdict = compareImages({floats({1, 1000, 0, 1}), floats({1.5f, 1001, 0, 1}), TexelKind::kFloat});
  EXPECT_EQ(verdict.differing, 2u);
  EXPECT_EQ(verdict.beyond, 2u);
  EXPECT_EQ(verdict.pixel, 0u);
  EXPECT_EQ(verdict.largest, 0.5);
}

TEST(Rounding, LooksAtAllChannels) {
  const Words expected = floats({1});
  for (std::size_t channel = 0; channel < 4; ++channel) {
    Words found = expected;
    found[channel] = std::bit_cast<std::uint32_t>(2.0f);
    EXPECT_EQ(compareImages({expected, found, TexelKind::kFloat}).difference, Difference::kBeyondRounding) << channel;
  }
}

TEST(Rounding, TakesAWiderToleranceAndNone) {
  const Words expected = floats({0.5f}), found = floats({0.501f});
  EXPECT_EQ(compareImages({expected, found, TexelKind::kFloat}, 2e-3).difference, Difference::kRounding);
  EXPECT_EQ(compareImages({expected, found, TexelKind::kFloat}, 0).difference, Difference::kBeyondRounding);
  EXPECT_EQ(compareImages({expected, expected, TexelKind::kFloat}, 0).difference, Difference::kNone);
}

TEST(Rounding, LeavesPixelsOut) {
  const std::vector<bool> left_out = {false, true};
  EXPECT_EQ(compareImages({floats({1, 2}), floats({1, 3}), TexelKind::kFloat, &left_out}).difference, Difference::kNone);
  EXPECT_EQ(compareImages({floats({1, 2}), floats({3, 2}), TexelKind::kFloat, &left_out}).difference, Difference::kBeyondRounding);
}

TEST(Rounding, OfBytesIsOneStepInFewPixels) {
  const Words expected = steps(2000, 100);
  Words found = expected;
  found[0] = 101;
  found[4 * 1999 + 3] = 99;
  RoundingVerdict verdict = compareImages({expected, found, TexelKind::kUnorm8});
  EXPECT_EQ(verdict.difference, Difference::kRounding) << "two of 2000 are 0.1%";
  EXPECT_EQ(verdict.differing, 2u);
  found[4 * 7] = 101;
  EXPECT_EQ(compareImages({expected, found, TexelKind::kUnorm8}).difference, Difference::kBeyondRounding) << "three are more";
  found = expected;
  found[4 * 7] = 102;
  verdict = compareImages({expected, found, TexelKind::kUnorm8});
  EXPECT_EQ(verdict.difference, Difference::kBeyondRounding) << "two steps";
  EXPECT_EQ(verdict.pixel, 7u);
  EXPECT_EQ(verdict.largest, 2);
}

TEST(Rounding, OfBytesCountsThePixelsThatAreCompared) {
  const Words expected = steps(2000, 100);
  Words found = expected;
  found[0] = 101;
  std::vector<bool> left_out(2000, true);
  for (std::size_t pixel = 0; pixel < 999; ++pixel) left_out[pixel] = false;
  EXPECT_EQ(compareImages({expected, found, TexelKind::kUnorm8, &left_out}).difference, Difference::kBeyondRounding);
  left_out[999] = false;
  EXPECT_EQ(compareImages({expected, found, TexelKind::kUnorm8, &left_out}).difference, Difference::kRounding);
}

TEST(Rounding, IsNothingToIntegers) {
  const Words expected = {7, 0, 0xffffffffu, 0};
  Words found = expected;
  EXPECT_EQ(compareImages({expected, found, TexelKind::kInteger}).difference, Difference::kNone);
  found[0] = 8;
  EXPECT_EQ(compareImages({expected, found, TexelKind::kInteger}).difference, Difference::kBeyondRounding);
}

TEST(Rounding, QuantizesAsATargetDoes) {
  EXPECT_EQ(unorm8Of(floats({0.5f})), (Words{128, 0, 0, 0}));
  EXPECT_EQ(unorm8Of(floats({-1})), (Words{0, 0, 0, 0}));
  EXPECT_EQ(unorm8Of(floats({7})), (Words{255, 0, 0, 0}));
  EXPECT_EQ(unorm8Of(floats({kNaN})), (Words{0, 0, 0, 0}));
  EXPECT_EQ(unorm8Of(floats({1.0f / 255})), (Words{1, 0, 0, 0}));
}

}  // namespace
}  // namespace reprise
