// The rule of rounding, word by word and image by image.
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

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

struct Case {
  const char* name;
  ChannelKind kind;
  std::uint32_t expected, found;
  Nearness nearness;
  double tolerance = kRoundingTolerance;
};

Case ofFloats(const char* name, float expected, float found, Nearness nearness, double tolerance = kRoundingTolerance) {
  return {name, ChannelKind::kFloat, bits(expected), bits(found), nearness, tolerance};
}

const Case kCases[] = {
    ofFloats("same", 0.25f, 0.25f, Nearness::kEqual),
    ofFloats("zeros", 0.0f, -0.0f, Nearness::kEqual),
    ofFloats("zeros_the_other_way", -0.0f, 0.0f, Nearness::kEqual),
    ofFloats("not_numbers", kNaN, -kNaN, Nearness::kEqual),
    ofFloats("the_same_not_numbers", kNaN, kNaN, Nearness::kEqual),
    ofFloats("infinities", kInfinity, kInfinity, Nearness::kEqual),
    ofFloats("one_unit_in_the_last_place", 0.25f, std::nextafter(0.25f, 1.0f), Nearness::kRounded),
    ofFloats("near_zero", 0.0f, 0.9e-5f, Nearness::kRounded),
    ofFloats("too_far_from_zero", 0.0f, 1.1e-5f, Nearness::kBeyond),
    ofFloats("near_a_half", 0.5f, 0.5f + 0.9e-5f, Nearness::kRounded),
    ofFloats("too_far_below_a_half", 0.5f, 0.5f - 1.1e-5f, Nearness::kBeyond),
    ofFloats("large", 1000.0f, 1000.009f, Nearness::kRounded),
    ofFloats("too_far_from_large", 1000.0f, 1000.011f, Nearness::kBeyond),
    ofFloats("too_far_from_large_and_negative", -1000.0f, -1000.011f, Nearness::kBeyond),
    ofFloats("other_sign", 0.5f, -0.5f, Nearness::kBeyond),
    ofFloats("opposite_infinities", kInfinity, -kInfinity, Nearness::kBeyond),
    ofFloats("no_number_any_more", 1.0f, kNaN, Nearness::kBeyond),
    ofFloats("a_number_after_all", kNaN, 1.0f, Nearness::kBeyond),
    ofFloats("infinite", 3e38f, kInfinity, Nearness::kBeyond),
    ofFloats("within_a_wider_tolerance", 0.5f, 0.501f, Nearness::kRounded, 2e-3),
    ofFloats("beyond_a_wider_tolerance", 0.5f, 0.503f, Nearness::kBeyond, 2e-3),
    ofFloats("one_unit_where_none_may_be_off", 1.0f, std::nextafter(1.0f, 2.0f), Nearness::kBeyond, 0),
    ofFloats("zeros_where_none_may_be_off", 0.0f, -0.0f, Nearness::kEqual, 0),
    // As floats these would be next to nothing.
    {"same_integers", ChannelKind::kInteger, 1, 1, Nearness::kEqual},
    {"neighbouring_integers", ChannelKind::kInteger, 1, 2, Nearness::kBeyond},
    {"integers_like_zeros", ChannelKind::kInteger, 0, 0x80000000u, Nearness::kBeyond},
    {"same_bytes", ChannelKind::kUnorm8, 100, 100, Nearness::kEqual},
    {"a_step_up", ChannelKind::kUnorm8, 100, 101, Nearness::kRounded},
    {"a_step_down", ChannelKind::kUnorm8, 100, 99, Nearness::kRounded},
    {"two_steps", ChannelKind::kUnorm8, 100, 102, Nearness::kBeyond},
};

class RoundingRule : public testing::TestWithParam<Case> {};

TEST_P(RoundingRule, OfAWord) {
  EXPECT_EQ(nearnessOf(GetParam().expected, GetParam().found, GetParam().kind, GetParam().tolerance), GetParam().nearness);
}

// In every channel of the last of so many pixels that one of them may be a step off.
TEST_P(RoundingRule, OfAnImage) {
  constexpr std::size_t kPixels = 1000;
  for (std::size_t channel = 0; channel < 4; ++channel) {
    Words expected(kPixels * 4, bits(0.5f)), found = expected;
    expected[(kPixels - 1) * 4 + channel] = GetParam().expected;
    found[(kPixels - 1) * 4 + channel] = GetParam().found;
    const RoundingVerdict verdict = compareImages({expected, found, GetParam().kind}, GetParam().tolerance);
    EXPECT_EQ(verdict.nearness, GetParam().nearness) << channel;
    EXPECT_EQ(verdict.differing, GetParam().nearness == Nearness::kEqual ? 0u : 1u) << channel;
    EXPECT_EQ(verdict.beyond, GetParam().nearness == Nearness::kBeyond ? 1u : 0u) << channel;
    EXPECT_EQ(verdict.pixel, GetParam().nearness == Nearness::kEqual ? 0u : kPixels - 1) << channel;
  }
}

INSTANTIATE_TEST_SUITE_P(Words, RoundingRule, testing::ValuesIn(kCases), [](const testing::TestParamInfo<Case>& one) { return one.param.name; });

TEST(Rounding, TellsThePixelThatIsOffMostForItsSize) {
  const RoundingVerdict verdict = compareImages({floats({1, 1000, 0, 1}), floats({1.5f, 1001, 0, 1}), ChannelKind::kFloat});
  EXPECT_EQ(verdict.differing, 2u);
  EXPECT_EQ(verdict.beyond, 2u);
  EXPECT_EQ(verdict.pixel, 0u);
  EXPECT_EQ(verdict.largest, 0.5);
}

TEST(Rounding, LeavesPixelsOut) {
  const std::vector<bool> left_out = {false, true};
  EXPECT_EQ(compareImages({floats({1, 2}), floats({1, 3}), ChannelKind::kFloat, &left_out}).nearness, Nearness::kEqual);
  EXPECT_EQ(compareImages({floats({1, 2}), floats({3, 2}), ChannelKind::kFloat, &left_out}).nearness, Nearness::kBeyond);
}

TEST(Rounding, OfBytesIsOneStepInFewPixels) {
  const Words expected = steps(2000, 100);
  Words found = expected;
  found[0] = 101;
  found[4 * 1999 + 3] = 99;
  RoundingVerdict verdict = compareImages({expected, found, ChannelKind::kUnorm8});
  EXPECT_EQ(verdict.nearness, Nearness::kRounded) << "two of 2000 are 0.1%";
  EXPECT_EQ(verdict.differing, 2u);
  found[4 * 7] = 101;
  EXPECT_EQ(compareImages({expected, found, ChannelKind::kUnorm8}).nearness, Nearness::kBeyond) << "three are more";
  found = expected;
  found[4 * 7] = 102;
  verdict = compareImages({expected, found, ChannelKind::kUnorm8});
  EXPECT_EQ(verdict.nearness, Nearness::kBeyond) << "two steps";
  EXPECT_EQ(verdict.pixel, 7u);
  EXPECT_EQ(verdict.largest, 2);
}

TEST(Rounding, OfBytesCountsThePixelsThatAreCompared) {
  const Words expected = steps(2000, 100);
  Words found = expected;
  found[0] = 101;
  std::vector<bool> left_out(2000, true);
  for (std::size_t pixel = 0; pixel < 999; ++pixel) left_out[pixel] = false;
  EXPECT_EQ(compareImages({expected, found, ChannelKind::kUnorm8, &left_out}).nearness, Nearness::kBeyond);
  left_out[999] = false;
  EXPECT_EQ(compareImages({expected, found, ChannelKind::kUnorm8, &left_out}).nearness, Nearness::kRounded);
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
