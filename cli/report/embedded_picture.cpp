#include "cli/report/embedded_picture.h"

#include <memory>
#include <string_view>

#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace reprise {
namespace {

constexpr int kChannels = 3;

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    for (std::size_t i = 0; i < 3; ++i) group = group << 8 | (i < count ? bytes[at + i] : 0u);
    for (std::size_t i = 0; i < 4; ++i) text += i <= count ? kDigits[group >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

std::optional<Picture> decoded(const std::vector<std::uint8_t>& png) {
  Picture picture;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> texels(
      stbi_load_from_memory(png.data(), static_cast<int>(png.size()), &picture.width, &picture.height, &channels, kChannels), stbi_image_free);
  if (!texels) return std::nullopt;
  picture.rgb.assign(texels.get(), texels.get() + static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * kChannels);
  return picture;
}

Picture shrunk(const Picture& from, int factor) {
  Picture to{from.width / factor, from.height / factor, {}};
  to.rgb.resize(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height) * kChannels);
  std::size_t at = 0;
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x)
      for (int channel = 0; channel < kChannels; ++channel) {
        int sum = 0;
        for (int dy = 0; dy < factor; ++dy)
          for (int dx = 0; dx < factor; ++dx)
            sum += from.rgb[static_cast<std::size_t>(((y * factor + dy) * from.width + x * factor + dx) * kChannels + channel)];
        to.rgb[at++] = static_cast<std::uint8_t>((sum + factor * factor / 2) / (factor * factor));
      }
  return to;
}

}  // namespace

std::string pngDataUri(const std::vector<std::uint8_t>& png) { return "data:image/png;base64," + base64(png); }

std::optional<std::string> jpegDataUri(const std::vector<std::uint8_t>& png, int most_width, int quality) {
  std::optional<Picture> picture = decoded(png);
  if (!picture) return std::nullopt;
  const int factor = (picture->width + most_width - 1) / most_width;
  if (factor > 1 && picture->height >= factor) picture = shrunk(*picture, factor);
  std::vector<std::uint8_t> jpeg;
  const auto append = [](void* to, void* data, int size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(to)->insert(static_cast<std::vector<std::uint8_t>*>(to)->end(), bytes, bytes + size);
  };
  if (stbi_write_jpg_to_func(append, &jpeg, picture->width, picture->height, kChannels, picture->rgb.data(), quality) == 0) return std::nullopt;
  return "data:image/jpeg;base64," + base64(jpeg);
}

}  // namespace reprise
