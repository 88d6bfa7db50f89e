#include "profiler/scene/texture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

#include <stb/stb_image.h>

#include "profiler/scenario/names.h"
#include "profiler/scenario/texture_file.h"
#include "profiler/scene/lattice_noise.h"

namespace reprise {
namespace {

using Color = std::array<float, 4>;

Color mixColors(const Color& a, const Color& b, double part) {
  Color mixed;
  for (std::size_t i = 0; i < 4; ++i)
    mixed[i] = static_cast<float>(a[i] + part * (static_cast<double>(b[i]) - a[i]));
  return mixed;
}

Color checkerTexel(const TextureSpec& spec, int x, int y) {
  const int column = x * spec.cells / spec.size, row = y * spec.cells / spec.size;
  return (column + row) % 2 == 0 ? spec.color_a : spec.color_b;
}

Color noiseTexel(const TextureSpec& spec, int x, int y) {
  const double scale = static_cast<double>(spec.cells) / spec.size;
  return mixColors(spec.color_a, spec.color_b,
                   fractalNoise((x + 0.5) * scale, (y + 0.5) * scale, spec.seed, spec.cells));
}

Color gradientTexel(const TextureSpec& spec, int y) {
  return mixColors(spec.color_a, spec.color_b, (y + 0.5) / spec.size);
}

// Latitude and longitude of the whole sphere: color_a in the zenith, color_b at the horizon, a dark ground
// below it, and a sun of up to 20 times color_a a third of the way up.
Color skyTexel(const TextureSpec& spec, int x, int y) {
  const double u = (x + 0.5) / spec.size, v = (y + 0.5) / spec.size;
  const double height = 1 - 2 * v;
  Color color = height > 0
                    ? mixColors(spec.color_b, spec.color_a, std::sqrt(height))
                    : mixColors(spec.color_b, {0, 0, 0, spec.color_b[3]}, std::min(1.0, 0.6 - 0.4 * height));
  const double distance = std::hypot((u - 0.25) * 2, v - 1.0 / 3);
  const double sun = 20 * std::exp(-distance * distance / (2 * 0.03 * 0.03));
  for (std::size_t i = 0; i < 3; ++i) color[i] += static_cast<float>(sun * spec.color_a[i]);
  return color;
}

// A tangent-space normal map, (n + 1) / 2, of the heights of the noise. Slopes are central differences over a texel.
Color bumpsTexel(const TextureSpec& spec, int x, int y) {
  const double scale = static_cast<double>(spec.cells) / spec.size;
  const auto height = [&](double column, double row) {
    return spec.height * fractalNoise((column + 0.5) * scale, (row + 0.5) * scale, spec.seed, spec.cells);
  };
  const double slope_x = (height(x + 0.5, y) - height(x - 0.5, y)) / scale, slope_y = (height(x, y + 0.5) - height(x, y - 0.5)) / scale;
  const double length = std::sqrt(slope_x * slope_x + slope_y * slope_y + 1);
  return {static_cast<float>(0.5 - 0.5 * slope_x / length), static_cast<float>(0.5 - 0.5 * slope_y / length),
          static_cast<float>(0.5 + 0.5 / length), 1};
}

Color generatedTexel(const TextureSpec& spec, int x, int y) {
  switch (spec.kind) {
    case TextureKind::kChecker:
      return checkerTexel(spec, x, y);
    case TextureKind::kNoise:
      return noiseTexel(spec, x, y);
    case TextureKind::kGradient:
      return gradientTexel(spec, y);
    case TextureKind::kBumps:
      return bumpsTexel(spec, x, y);
    default:
      return skyTexel(spec, x, y);
  }
}

Error undecodable(const TextureSpec& spec, const std::string& reason) {
  return {ErrorKind::kInput, "texture.format",
          "texture '" + spec.name + "': '" + spec.path + "' cannot be decoded (" + reason +
              "), expected a PNG, JPEG or HDR file",
          spec.file_place};
}

struct StbFree {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

std::string stbReason() {
  const char* reason = stbi_failure_reason();
  return reason ? reason : "unknown content";
}

// Decodes to 8 bits, or to floats if the file has a high dynamic range. The size has been checked.
Result<TextureImage> decode(const TextureSpec& spec, const stbi_uc* bytes, int byte_count) {
  TextureImage image;
  image.high_dynamic_range = stbi_is_hdr_from_memory(bytes, byte_count) != 0;
  int channels = 0;
  if (image.high_dynamic_range) {
    const std::unique_ptr<float, StbFree> pixels(
        stbi_loadf_from_memory(bytes, byte_count, &image.width, &image.height, &channels, 4));
    if (!pixels) return undecodable(spec, stbReason());
    image.rgba.assign(pixels.get(), pixels.get() + static_cast<std::size_t>(image.width) * image.height * 4);
    return image;
  }
  const std::unique_ptr<stbi_uc, StbFree> pixels(
      stbi_load_from_memory(bytes, byte_count, &image.width, &image.height, &channels, 4));
  if (!pixels) return undecodable(spec, stbReason());
  image.rgba.resize(static_cast<std::size_t>(image.width) * image.height * 4);
  std::transform(pixels.get(), pixels.get() + image.rgba.size(), image.rgba.begin(),
                 [](stbi_uc value) { return static_cast<float>(value) / 255.0f; });
  return image;
}

Result<TextureImage> loadTexture(const TextureSpec& spec) {
  REPRISE_ASSIGN(const std::string content, readTextureFile(spec));
  return decodeTexture(spec, content);
}

}  // namespace

Result<TextureImage> decodeTexture(const TextureSpec& spec, const std::string& content) {
  const auto* bytes = reinterpret_cast<const stbi_uc*>(content.data());
  const int byte_count = static_cast<int>(std::min<std::size_t>(content.size(), 1u << 30));
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(bytes, byte_count, &width, &height, &channels))
    return undecodable(spec, stbReason());
  if (width < 1 || height < 1 || width > kMaxTextureSize || height > kMaxTextureSize) {
    return undecodable(spec, std::to_string(width) + "x" + std::to_string(height) + " texels, at most " +
                                 std::to_string(kMaxTextureSize) + " each way");
  }
  return decode(spec, bytes, byte_count);
}

Result<TextureImage> buildTexture(const TextureSpec& spec) {
  if (spec.kind == TextureKind::kFile) return loadTexture(spec);
  TextureImage image;
  image.width = image.height = spec.size;
  image.high_dynamic_range = spec.kind == TextureKind::kSky;
  image.rgba.reserve(static_cast<std::size_t>(spec.size) * spec.size * 4);
  for (int y = 0; y < spec.size; ++y) {
    for (int x = 0; x < spec.size; ++x) {
      for (const float value : generatedTexel(spec, x, y)) image.rgba.push_back(value);
    }
  }
  return image;
}

}  // namespace reprise
