#include "profiler/session/display.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace reprise {
namespace {

std::span<const std::byte> bytesOfFloats(const std::vector<float>& values) { return std::as_bytes(std::span(values)); }

TEST(Display, BytesAndFloatsOfTheSameColorAreDisplayedAlike) {
  for (const ToneMap tone_map : {ToneMap::kNone, ToneMap::kReinhard, ToneMap::kAces}) {
    std::vector<std::uint8_t> bytes;
    std::vector<float> floats;
    for (int value = 0; value < 256; ++value)
      for (int channel = 0; channel < 4; ++channel) {
        bytes.push_back(static_cast<std::uint8_t>((value + 40 * channel) % 256));
        floats.push_back(static_cast<float>(bytes.back()) / 255.0f);
      }
    DisplayImage from_bytes{16, 16, {}}, from_floats{16, 16, {}};
    toDisplay(std::as_bytes(std::span(bytes)), VK_FORMAT_R8G8B8A8_UNORM, {tone_map, 1.5f}, from_bytes, nullptr);
    toDisplay(bytesOfFloats(floats), VK_FORMAT_R32G32B32A32_SFLOAT, {tone_map, 1.5f}, from_floats, nullptr);
    EXPECT_EQ(from_bytes.rgb, from_floats.rgb);
  }
}

TEST(Display, MarksPixelsThatAreNotFinite) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::vector<float> texels = {0.5f, 0.25f, 2, 1, 0.5f, NAN, 0.5f, 1, kInfinity, 0, 0, 1, 1, 1, 1, -kInfinity};
  DisplayImage image{4, 1, {}};
  std::vector<std::uint8_t> nonfinite;
  toDisplay(bytesOfFloats(texels), VK_FORMAT_R32G32B32A32_SFLOAT, {}, image, &nonfinite);
  EXPECT_EQ(nonfinite, (std::vector<std::uint8_t>{0, 1, 1, 1}));
  const std::vector<float> shown(image.rgb.begin(), image.rgb.begin() + 3);
  EXPECT_EQ(shown, (std::vector<float>{0.5f, 0.25f, 1}));
  for (std::size_t i = 3; i < image.rgb.size(); ++i) EXPECT_EQ(image.rgb[i], 0);
}

TEST(Display, ToneMapsRiseFromZeroAndStayBelowOne) {
  for (const ToneMap tone_map : {ToneMap::kReinhard, ToneMap::kAces}) {
    float last = toneMapped(0, {tone_map, 1});
    EXPECT_EQ(last, 0);
    for (float x = 0.01f; x < 1000; x *= 1.3f) {
      const float mapped = toneMapped(x, {tone_map, 1});
      EXPECT_GE(mapped, last);
      EXPECT_LE(mapped, 1);
      last = mapped;
    }
  }
  EXPECT_EQ(toneMapped(1, {ToneMap::kReinhard, 1}), 0.5f);
  EXPECT_EQ(toneMapped(0.25f, {ToneMap::kNone, 2}), 0.5f);
}

}  // namespace
}  // namespace reprise
