// Metrics of tiles: what they see of a corner, of the dark and of blocks.
#include "profiler/metrics/tiles.h"

#include <gtest/gtest.h>

#include <numeric>

#include "profiler/metrics/flip.h"
#include "tests/metrics/test_images.h"

namespace reprise {
namespace {

double valueOf(const std::string& name, const DisplayImage& original, const DisplayImage& cached, const std::vector<std::uint8_t>* ages = nullptr) {
  const CoverageMask mask = fullMask(original.width, original.height);
  return findMetric(name)->value({&original, &cached, &original, &original, &mask, ages});
}

// As a scenario's exposure does.
DisplayImage exposed(DisplayImage image, float gain) {
  for (float& value : image.rgb) value = std::min(1.0f, gain * value);
  return image;
}

// Adds `by` to the left half of each block of 16x16 pixels, so that both halves border on each other.
DisplayImage withSteps(DisplayImage image, float by) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (x / 8 % 2 == 0)
        for (int channel = 0; channel < 3; ++channel) image.rgb[static_cast<std::size_t>(3 * (y * image.width + x) + channel)] += by;
  return image;
}

std::vector<std::uint8_t> agesOfColumns(int width, int height) {
  std::vector<std::uint8_t> ages;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) ages.push_back(static_cast<std::uint8_t>(x / 8 % 2));
  return ages;
}

TEST(Tiles, CoverTheFrameOnce) {
  for (const auto& [width, height] : {std::pair{640, 360}, {1280, 720}, {64, 64}, {31, 200}, {97, 1}}) {
    std::vector<int> seen(static_cast<std::size_t>(width * height));
    const CoverageMask mask = fullMask(width, height);
    for (const Tile& tile : tilesOf(flatImage(width, height, 0.5f), mask)) visitTile(tile, mask, [&](std::size_t pixel) { ++seen[pixel]; });
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), width * height) << width << "x" << height;
  }
}

TEST(Tiles, ThatAreHardlyCoveredDoNotCountBesideOthers) {
  CoverageMask mask = fullMask(128, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 64; x < 128; ++x) mask.kind[static_cast<std::size_t>(y * 128 + x)] = y == 0 && x < 70 ? 1 : 0;
  EXPECT_EQ(tilesOf(flatImage(128, 64, 0.5f), mask).size(), 1u);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) mask.kind[static_cast<std::size_t>(y * 128 + x)] = 0;
  EXPECT_EQ(tilesOf(flatImage(128, 64, 0.5f), mask).size(), 1u) << "the only one that is covered at all";
}

// An error in one of fifty tiles is as bad as it is there, however large the frame.
TEST(TileMetrics, DoNotDependOnHowEmptyTheFrameIs) {
  DisplayImage small = smoothImage(64, 64), large = smoothImage(640, 320);
  DisplayImage small_off = withNoise(small, 0.1f, 1), large_off = large;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 3 * 64; ++x) large_off.rgb[static_cast<std::size_t>(y * 640 * 3 + x)] = small_off.rgb[static_cast<std::size_t>(y * 64 * 3 + x)];
  for (const char* name : {"tile_rms", "tile_flicker", "tile_flip"})
    EXPECT_NEAR(valueOf(name, large, large_off), valueOf(name, small, small_off), 0.15 * valueOf(name, small, small_off)) << name;
  EXPECT_LT(valueOf("rms", large, large_off), 0.2 * valueOf("rms", small, small_off));
}

// The same scene, seen at a quarter of the exposure: the eye adapts.
TEST(TileMetrics, JudgeDarkContentAsTheEyeDoes) {
  DisplayImage rock = smoothImage(128, 64);
  for (float& value : rock.rgb) value = 0.15f + 0.08f * value;  // a mean of 0.19
  const DisplayImage off = withNoise(rock, 0.03f, 2);
  const std::vector<std::uint8_t> ages = blockAges(128, 64);
  for (const char* name : {"tile_rms", "tile_flicker", "tile_flip"}) {
    const double bright = valueOf(name, rock, off, &ages), dark = valueOf(name, exposed(rock, 0.25f), exposed(off, 0.25f), &ages);
    EXPECT_NEAR(dark, bright, 0.1 * bright) << name;
  }
  EXPECT_LT(valueOf("rms", exposed(rock, 0.25f), exposed(off, 0.25f)), 0.7 * valueOf("rms", rock, off));
}

TEST(Blocks, AreSeenWhereErrorsStepWithAge) {
  const DisplayImage image = flatImage(64, 64, 0.5f);
  const std::vector<std::uint8_t> ages = agesOfColumns(64, 64);
  EXPECT_NEAR(valueOf("blocks", image, withSteps(image, 0.1f), &ages), 0.1, 1e-4);
  EXPECT_NEAR(valueOf("blocks", image, withSteps(image, 0.02f), &ages), 0.02, 1e-4);
}

// The step that is plain on a flat wall is lost in gravel.
TEST(Blocks, AreMaskedByTheStepsOfTheImage) {
  const DisplayImage wall = flatImage(64, 64, 0.5f), gravel = withNoise(wall, 0.1f, 5);
  const std::vector<std::uint8_t> ages = agesOfColumns(64, 64);
  const double on_wall = valueOf("blocks", wall, withSteps(wall, 0.02f), &ages);
  EXPECT_LT(valueOf("blocks", gravel, withSteps(gravel, 0.02f), &ages), 0.1 * on_wall);
  EXPECT_GT(valueOf("blocks", gravel, withSteps(gravel, 0.02f), &ages), 0);
}

TEST(Blocks, AreNotSeenInErrorsThatDoNotFollowAges) {
  const DisplayImage image = smoothImage(64, 64);
  const std::vector<std::uint8_t> ages = agesOfColumns(64, 64);
  EXPECT_LT(valueOf("blocks", image, withNoise(image, 0.1f, 3), &ages), 0.02);
  const std::vector<std::uint8_t> one_age(64 * 64, 3);
  EXPECT_EQ(valueOf("blocks", image, withSteps(image, 0.1f), &one_age), 0);
}

TEST(TileFlip, IsTheSameWithTheOriginalsHalfMadeBefore) {
  const DisplayImage image = exposed(smoothImage(96, 64), 0.1f), off = withNoise(image, 0.05f, 4);
  const CoverageMask mask = fullMask(96, 64);
  const FlipOriginal half(image);
  MetricInputs inputs{.original = &image, .cached = &off, .mask = &mask};
  for (const char* name : {"flip", "tile_flip"}) {
    inputs.flip_original = nullptr;
    const double alone = findMetric(name)->value(inputs);
    inputs.flip_original = &half;
    EXPECT_EQ(findMetric(name)->value(inputs), alone) << name;
  }
}

}  // namespace
}  // namespace reprise
