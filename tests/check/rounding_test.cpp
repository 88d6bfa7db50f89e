// The rule of law 0 on tables: how far off is rounding, and whose witness counts.
#include "cli/check/rounding.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace reprise {
namespace {

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

TEST(Rounding, OfFloats) {
  const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const struct {
    float expected, found;
    Nearness nearness;
  } cases[] = {
      {1.0f, 1.0f, Nearness::kEqual},
      {0.0f, -0.0f, Nearness::kEqual},
      {-0.0f, 0.0f, Nearness::kEqual},
      {nan, nan, Nearness::kEqual},
      {nan, -nan, Nearness::kEqual},
      {infinity, infinity, Nearness::kEqual},
      {1.0f, std::nextafter(1.0f, 2.0f), Nearness::kRounded},
      {0.0f, 0.9e-5f, Nearness::kRounded},
      {0.0f, 1.1e-5f, Nearness::kBeyond},
      {0.5f, 0.5f + 0.9e-5f, Nearness::kRounded},
      {0.5f, 0.5f - 1.1e-5f, Nearness::kBeyond},
      {1000.0f, 1000.009f, Nearness::kRounded},
      {1000.0f, 1000.011f, Nearness::kBeyond},
      {-1000.0f, -1000.011f, Nearness::kBeyond},
      {1.0f, nan, Nearness::kBeyond},
      {nan, 1.0f, Nearness::kBeyond},
      {infinity, -infinity, Nearness::kBeyond},
      {1e38f, infinity, Nearness::kBeyond},
  };
  for (const auto& one : cases)
    EXPECT_EQ(nearnessOf(bits(one.expected), bits(one.found), ChannelKind::kFloat), one.nearness) << one.expected << ' ' << one.found;
  EXPECT_EQ(nearnessOf(bits(1.0f), bits(std::nextafter(1.0f, 2.0f)), ChannelKind::kFloat, 0), Nearness::kBeyond);
  EXPECT_EQ(nearnessOf(bits(0.0f), bits(-0.0f), ChannelKind::kFloat, 0), Nearness::kEqual);
}

// As floats 1 and 2 would be next to nothing.
TEST(Rounding, IntegersAreNotRounded) {
  EXPECT_EQ(nearnessOf(1, 1, ChannelKind::kWhole), Nearness::kEqual);
  EXPECT_EQ(nearnessOf(1, 2, ChannelKind::kWhole), Nearness::kBeyond);
  EXPECT_EQ(nearnessOf(0, 0x80000000u, ChannelKind::kWhole), Nearness::kBeyond);
}

std::vector<std::uint32_t> imageOf(std::size_t pixels, std::size_t stepped, std::uint32_t step) {
  std::vector<std::uint32_t> image(pixels * 4, 100);
  for (std::size_t pixel = 0; pixel < stepped; ++pixel) image[pixel * 4 + pixel % 4] += step;
  return image;
}

TEST(Rounding, OfBytesIsOneStepInFewPixels) {
  const std::vector<std::uint32_t> expected = imageOf(4000, 0, 0);
  EXPECT_EQ(compareImages(expected, expected, ChannelKind::kByte).nearness, Nearness::kEqual);
  const ImageDifference few = compareImages(expected, imageOf(4000, 4, 1), ChannelKind::kByte);
  EXPECT_EQ(few.nearness, Nearness::kRounded);
  EXPECT_EQ(few.pixels, 4u);
  EXPECT_EQ(compareImages(expected, imageOf(4000, 5, 1), ChannelKind::kByte).nearness, Nearness::kBeyond);
  EXPECT_EQ(compareImages(expected, imageOf(4000, 1, 2), ChannelKind::kByte).nearness, Nearness::kBeyond);
  EXPECT_EQ(compareImages(imageOf(4000, 1, 1), expected, ChannelKind::kByte).nearness, Nearness::kRounded);
}

TEST(Rounding, TheFirstPixelThatIsFarthestOffIsTold) {
  const std::vector<std::uint32_t> expected(12, bits(1.0f));
  std::vector<std::uint32_t> found = expected;
  found[0] = bits(1.000001f);
  EXPECT_EQ(compareImages(expected, found, ChannelKind::kFloat).pixel, 0u);
  found[7] = bits(2.0f);
  found[9] = bits(3.0f);
  const ImageDifference difference = compareImages(expected, found, ChannelKind::kFloat);
  EXPECT_EQ(difference.nearness, Nearness::kBeyond);
  EXPECT_EQ(difference.pixel, 1u);
  EXPECT_EQ(difference.pixels, 3u);
}

TEST(Rounding, NeedsAWitness) {
  constexpr auto kUnknown = Computation::kUnknown, kSame = Computation::kSame, kDifferent = Computation::kDifferent;
  const struct {
    Evidence evidence;
    Judgement judgement;
  } cases[] = {
      {{Nearness::kEqual, false, kUnknown}, Judgement::kEqual},
      {{Nearness::kEqual, true, kDifferent}, Judgement::kOurs},
      {{Nearness::kRounded, false, kUnknown}, Judgement::kOurs},
      {{Nearness::kRounded, true, kUnknown}, Judgement::kRounded},
      {{Nearness::kRounded, false, kSame}, Judgement::kRounded},
      {{Nearness::kRounded, true, kDifferent}, Judgement::kOurs},
      {{Nearness::kBeyond, true, kUnknown}, Judgement::kOurs},
      {{Nearness::kBeyond, false, kSame}, Judgement::kOurs},
      {{Nearness::kBeyond, true, kSame}, Judgement::kEnlarged},
      {{Nearness::kBeyond, true, kDifferent}, Judgement::kOurs},
  };
  for (const auto& one : cases)
    EXPECT_EQ(judge(one.evidence), one.judgement) << static_cast<int>(one.evidence.as_given) << one.evidence.equal_without_contraction
                                                  << static_cast<int>(one.evidence.interpreted);
}

}  // namespace
}  // namespace reprise
