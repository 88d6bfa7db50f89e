#include "profiler/scene/texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/scenario/scenario_file.h"

namespace reprise {
namespace {

std::array<float, 4> texelOf(const TextureImage& image, int x, int y) {
  const auto first = static_cast<std::size_t>(y * image.width + x) * 4;
  return {image.rgba[first], image.rgba[first + 1], image.rgba[first + 2], image.rgba[first + 3]};
}

TextureSpec generated(TextureKind kind) {
  TextureSpec spec;
  spec.name = "texture";
  spec.kind = kind;
  spec.size = 32;
  spec.cells = 4;
  spec.color_a = {1, 0.5f, 0.25f, 1};
  spec.color_b = {0, 0, 0.75f, 1};
  return spec;
}

TextureSpec fromFile(const ScenarioFolder& folder, const std::string& name) {
  TextureSpec spec;
  spec.name = "texture";
  spec.kind = TextureKind::kFile;
  spec.path = (folder.path() / name).string();
  spec.file_place = {"scene.toml", 12, 3};
  return spec;
}

TEST(Texture, CheckerAlternates) {
  const TextureSpec spec = generated(TextureKind::kChecker);
  const Result<TextureImage> image = buildTexture(spec);
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->width, 32);
  EXPECT_EQ(image->height, 32);
  EXPECT_EQ(texelOf(*image, 0, 0), spec.color_a);
  EXPECT_EQ(texelOf(*image, 7, 7), spec.color_a);
  EXPECT_EQ(texelOf(*image, 8, 7), spec.color_b);
  EXPECT_EQ(texelOf(*image, 8, 8), spec.color_a);
}

TEST(Texture, GradientRunsFromTopToBottom) {
  const Result<TextureImage> image = buildTexture(generated(TextureKind::kGradient));
  ASSERT_TRUE(image.ok());
  EXPECT_NEAR(texelOf(*image, 3, 0)[0], 1, 0.02);
  EXPECT_NEAR(texelOf(*image, 3, 31)[0], 0, 0.02);
  EXPECT_EQ(texelOf(*image, 3, 9), texelOf(*image, 20, 9));
}

TEST(Texture, NoiseVariesWithoutASeam) {
  const Result<TextureImage> image = buildTexture(generated(TextureKind::kNoise));
  ASSERT_TRUE(image.ok());
  float inner = 0, seam = 0, low = 1, high = 0;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const float here = texelOf(*image, x, y)[0], next = texelOf(*image, (x + 1) % 32, y)[0];
      (x == 31 ? seam : inner) = std::max(x == 31 ? seam : inner, std::abs(here - next));
      low = std::min(low, here);
      high = std::max(high, here);
    }
  }
  EXPECT_GT(high - low, 0.3f);
  EXPECT_LE(seam, inner * 1.2f);
}

TEST(Texture, SkyHasASunBeyondTheDisplay) {
  const Result<TextureImage> image = buildTexture(generated(TextureKind::kSky));
  ASSERT_TRUE(image.ok());
  EXPECT_TRUE(image->high_dynamic_range);
  EXPECT_GT(*std::max_element(image->rgba.begin(), image->rgba.end()), 4);
  EXPECT_GE(*std::min_element(image->rgba.begin(), image->rgba.end()), 0);
}

// 2x2 texels, red, green; blue, and white of half opacity: a PNG of 8 bits with stored (uncompressed) data.
const unsigned char kFourTexels[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44,
    0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x06, 0x00, 0x00, 0x00, 0x72,
    0xb6, 0x0d, 0x24, 0x00, 0x00, 0x00, 0x1d, 0x49, 0x44, 0x41, 0x54, 0x78, 0x01, 0x01, 0x12,
    0x00, 0xed, 0xff, 0x00, 0xff, 0x00, 0x00, 0xff, 0x00, 0xff, 0x00, 0xff, 0x00, 0x00, 0x00,
    0xff, 0xff, 0xff, 0xff, 0xff, 0x80, 0x49, 0x49, 0x09, 0x78, 0x4b, 0xd9, 0xce, 0x03, 0x00,
    0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

TEST(Texture, BumpsAreUnitNormalsThatRepeatWithoutASeam) {
  TextureSpec spec = generated(TextureKind::kBumps);
  spec.height = 0.5f;
  const Result<TextureImage> image = buildTexture(spec);
  ASSERT_TRUE(image.ok());
  double tilt = 0;
  for (int y = 0; y < spec.size; ++y)
    for (int x = 0; x < spec.size; ++x) {
      const auto texel = texelOf(*image, x, y);
      const double nx = 2 * texel[0] - 1, ny = 2 * texel[1] - 1, nz = 2 * texel[2] - 1;
      ASSERT_NEAR(nx * nx + ny * ny + nz * nz, 1, 1e-5);
      ASSERT_GT(nz, 0);
      tilt = std::max(tilt, std::hypot(nx, ny));
    }
  EXPECT_GT(tilt, 0.1);
  for (int y = 0; y < spec.size; ++y)
    EXPECT_LT(std::abs(texelOf(*image, 0, y)[0] - texelOf(*image, spec.size - 1, y)[0]), 0.35f) << y;
}

TEST(Texture, ReadsPngFromTheTop) {
  const ScenarioFolder folder;
  folder.write("four.png", std::string(reinterpret_cast<const char*>(kFourTexels), sizeof kFourTexels));
  const Result<TextureImage> image = buildTexture(fromFile(folder, "four.png"));
  ASSERT_TRUE(image.ok()) << formatError(image.error());
  ASSERT_EQ(image->width, 2);
  ASSERT_EQ(image->height, 2);
  EXPECT_FALSE(image->high_dynamic_range);
  EXPECT_EQ(texelOf(*image, 0, 0), (std::array<float, 4>{1, 0, 0, 1}));
  EXPECT_EQ(texelOf(*image, 1, 0), (std::array<float, 4>{0, 1, 0, 1}));
  EXPECT_EQ(texelOf(*image, 0, 1), (std::array<float, 4>{0, 0, 1, 1}));
  EXPECT_EQ(texelOf(*image, 1, 1), (std::array<float, 4>{1, 1, 1, 128 / 255.0f}));
}

TEST(Texture, ReadsHdr) {
  const ScenarioFolder folder;
  // One texel of RGBE: mantissas 128, 64, 32 with exponent 2^(131 - 128) / 256.
  folder.write("one.hdr",
               std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n") + "\x80\x40\x20\x83");
  const Result<TextureImage> image = buildTexture(fromFile(folder, "one.hdr"));
  ASSERT_TRUE(image.ok()) << formatError(image.error());
  EXPECT_TRUE(image->high_dynamic_range);
  EXPECT_EQ(texelOf(*image, 0, 0), (std::array<float, 4>{4, 2, 1, 1}));
}

TEST(Texture, ThatIsCutShortIsRefused) {
  const ScenarioFolder folder;
  folder.write("short.png", std::string(reinterpret_cast<const char*>(kFourTexels), sizeof kFourTexels / 2));
  const Result<TextureImage> image = buildTexture(fromFile(folder, "short.png"));
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, "texture.format");
}

TEST(Texture, ThatIsNoImageIsRefusedAtItsPlace) {
  const ScenarioFolder folder;
  folder.write("note.png", "no image");
  const Result<TextureImage> image = buildTexture(fromFile(folder, "note.png"));
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, "texture.format");
  EXPECT_EQ(image.error().place, (Place{"scene.toml", 12, 3}));
  EXPECT_NE(image.error().message.find("note.png"), std::string::npos);
}

TEST(Texture, ThatIsNotThereIsMissing) {
  const ScenarioFolder folder;
  EXPECT_EQ(buildTexture(fromFile(folder, "nonesuch.png")).error().code, "texture.missing");
}

}  // namespace
}  // namespace reprise
