// Images for the tests of metrics.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "profiler/metrics/metrics.h"

namespace reprise {

inline DisplayImage flatImage(int width, int height, float value) {
  return {width, height, std::vector<float>(static_cast<std::size_t>(3) * width * height, value)};
}

inline CoverageMask fullMask(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height, 1)};
}

// Smooth colours in [0.25, 0.75], so that noise of up to 0.25 is never cut.
inline DisplayImage smoothImage(int width, int height) {
  DisplayImage image = flatImage(width, height, 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        image.rgb[3 * (static_cast<std::size_t>(y) * width + x) + channel] =
            0.5f + 0.25f * std::sin(0.2f * x + 0.3f * y + channel);
      }
    }
  }
  return image;
}

// Ages of blocks of 8x8 pixels that are refreshed in turn.
inline std::vector<std::uint8_t> blockAges(int width, int height) {
  std::vector<std::uint8_t> ages;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) ages.push_back(static_cast<std::uint8_t>((x / 8 + y / 8) % 2));
  return ages;
}

// image + amplitude · noise in [−1, 1]; the same noise for the same seed, whatever the amplitude.
inline DisplayImage withNoise(DisplayImage image, float amplitude, std::uint32_t seed) {
  std::mt19937 random(seed);
  for (float& value : image.rgb) {
    const float unit = static_cast<float>(random() >> 8) / static_cast<float>(1 << 24);
    value = std::fmin(1.0f, std::fmax(0.0f, value + amplitude * (2 * unit - 1)));
  }
  return image;
}

}  // namespace reprise
