#include "profiler/metrics/image.h"

#include <cmath>

#include "runtime/base/check.h"
#include "runtime/base/file.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace reprise {

namespace {

std::uint8_t byteFromUnit(float value) {
  if (!(value > 0)) return 0;  // NaN is black
  return value >= 1 ? 255 : static_cast<std::uint8_t>(std::lround(value * 255));
}

void appendBytes(void* context, void* bytes, int count) {
  auto* png = static_cast<std::vector<std::uint8_t>*>(context);
  const auto* first = static_cast<const std::uint8_t*>(bytes);
  png->insert(png->end(), first, first + count);
}

}  // namespace

std::vector<std::uint8_t> encodePng(const DisplayImage& image) {
  REPRISE_CHECK(image.width > 0 && image.height > 0, image.width, image.height);
  REPRISE_CHECK(image.rgb.size() == 3 * static_cast<std::size_t>(image.width) * image.height, image.rgb.size(),
                image.width, image.height);
  std::vector<std::uint8_t> bytes(image.rgb.size()), png;
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = byteFromUnit(image.rgb[i]);
  const int written =
      stbi_write_png_to_func(appendBytes, &png, image.width, image.height, 3, bytes.data(), 3 * image.width);
  REPRISE_CHECK(written != 0, image.width, image.height);
  return png;
}

Result<void> writePng(const DisplayImage& image, const std::filesystem::path& path) {
  const std::vector<std::uint8_t> png = encodePng(image);
  return writeFile(path, {reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace reprise
