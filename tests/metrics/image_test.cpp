#include "profiler/metrics/image.h"

#include <gtest/gtest.h>

#include "runtime/base/file.h"
#include "tests/metrics/scratch_folder.h"
#include "tests/metrics/test_images.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#include <stb/stb_image.h>

namespace reprise {
namespace {

struct DecodedPng {
  int width = 0, height = 0, channels = 0;
  std::vector<std::uint8_t> bytes;
};

DecodedPng decode(const std::string& png) {
  DecodedPng decoded;
  std::uint8_t* pixels =
      stbi_load_from_memory(reinterpret_cast<const std::uint8_t*>(png.data()), static_cast<int>(png.size()),
                            &decoded.width, &decoded.height, &decoded.channels, 3);
  if (!pixels) return decoded;
  decoded.bytes.assign(pixels, pixels + std::size_t{3} * decoded.width * decoded.height);
  stbi_image_free(pixels);
  return decoded;
}

std::string encoded(const DisplayImage& image) {
  const std::vector<std::uint8_t> png = encodePng(image);
  return {png.begin(), png.end()};
}

TEST(Png, HoldsTheImageRoundedToBytes) {
  const DisplayImage image = smoothImage(37, 19);
  const DecodedPng decoded = decode(encoded(image));
  ASSERT_EQ(decoded.width, 37);
  ASSERT_EQ(decoded.height, 19);
  EXPECT_EQ(decoded.channels, 3);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    ASSERT_NEAR(decoded.bytes[i] / 255.0, image.rgb[i], 0.5 / 255 + 1e-6) << i;
  }
}

TEST(Png, CutsWhatLiesOutsideTheUnitInterval) {
  DisplayImage image = flatImage(2, 1, 0);
  image.rgb = {-1, 2, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1, 0};
  EXPECT_EQ(decode(encoded(image)).bytes, (std::vector<std::uint8_t>{0, 255, 0, 255, 255, 0}));
}

TEST(Png, IsWrittenToTheFile) {
  const ScratchFolder folder;
  const DisplayImage image = smoothImage(8, 8);
  ASSERT_TRUE(writePng(image, folder / "a.png").ok());
  EXPECT_EQ(readFile(folder / "a.png").value(), encoded(image));
}

TEST(Png, SaysWhereItCannotBeWritten) {
  const ScratchFolder folder;
  ASSERT_TRUE(writeFile(folder / "file", "x").ok());
  const Result<void> written = writePng(smoothImage(8, 8), folder / "file" / "a.png");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, "file.unwritable");
}

}  // namespace
}  // namespace reprise
