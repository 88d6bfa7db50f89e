#include <array>
#include <cmath>
#include <functional>

#include "tests/report/sample_run.h"

namespace reprise::sample {
namespace {

constexpr std::uint32_t kWidth = 320, kHeight = 180;

using Bytes = std::vector<std::uint8_t>;
using Rgb = std::array<double, 3>;

void putBig(Bytes& out, std::uint32_t word) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(word >> shift));
}

std::uint32_t crc32(const Bytes& bytes, std::size_t from) {
  std::uint32_t crc = ~0u;
  for (std::size_t i = from; i < bytes.size(); ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (0xedb88320u & (0u - (crc & 1u)));
  }
  return ~crc;
}

void putChunk(Bytes& png, const char* type, const Bytes& content) {
  putBig(png, static_cast<std::uint32_t>(content.size()));
  const std::size_t start = png.size();
  png.insert(png.end(), type, type + 4);
  png.insert(png.end(), content.begin(), content.end());
  putBig(png, crc32(png, start));
}

// An uncompressed PNG of what `color` gives for each pixel.
Bytes png(const std::function<Rgb(std::uint32_t, std::uint32_t)>& color) {
  Bytes packed = {0x78, 0x01};
  std::uint32_t low = 1, high = 0;  // Adler-32
  for (std::uint32_t y = 0; y < kHeight; ++y) {
    Bytes row = {0};
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      for (const double channel : color(x, y))
        row.push_back(static_cast<std::uint8_t>(255 * std::min(1.0, std::max(0.0, channel))));
    }
    const auto size = static_cast<std::uint16_t>(row.size());
    for (const unsigned part :
         {y + 1 == kHeight ? 1u : 0u, size & 255u, size >> 8 & 255u, ~size & 255u, ~size >> 8 & 255u}) {
      packed.push_back(static_cast<std::uint8_t>(part));
    }
    for (const std::uint8_t byte : row) low = (low + byte) % 65521, high = (high + low) % 65521;
    packed.insert(packed.end(), row.begin(), row.end());
  }
  putBig(packed, high << 16 | low);
  Bytes header;
  putBig(header, kWidth), putBig(header, kHeight);
  header.insert(header.end(), {8, 2, 0, 0, 0});
  Bytes image = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  putChunk(image, "IHDR", header);
  putChunk(image, "IDAT", packed);
  putChunk(image, "IEND", {});
  return image;
}

struct Spot {
  bool covered = false;
  double x = 0, y = 0, z = 0;  // on the unit sphere
};

Spot spotAt(std::uint32_t column, std::uint32_t row) {
  Spot spot;
  spot.x = (column - 160.0) / 82, spot.y = (90.0 - row) / 82;
  const double rest = 1 - spot.x * spot.x - spot.y * spot.y;
  spot.covered = rest > 0;
  spot.z = spot.covered ? std::sqrt(rest) : 0;
  return spot;
}

double marble(const Spot& spot) {
  double turbulence = 0;
  for (int octave = 0; octave < 6; ++octave) {
    const double f = std::pow(1.9, octave) * 2.3;
    turbulence += std::abs(std::sin(f * spot.x + octave) * std::cos(f * spot.y * 1.1 + 2 * octave) *
                           std::sin(f * spot.z + 3)) /
                  std::pow(1.7, octave);
  }
  return 0.5 + 0.5 * std::sin(6 * spot.x + 5 * turbulence);
}

Rgb shaded(const Spot& spot, double vein) {
  if (!spot.covered) return {0.04, 0.05, 0.07};
  const double light = std::max(0.0, 0.5 * spot.x + 0.5 * spot.y + 0.7 * spot.z);
  const double highlight = std::pow(std::max(0.0, 0.32 * spot.x + 0.36 * spot.y + 0.87 * spot.z), 60);
  return {light * (0.9 - 0.55 * vein) + highlight, light * (0.88 - 0.62 * vein) + highlight,
          light * (0.82 - 0.5 * vein) + highlight};
}

bool isMiss(std::uint32_t x, std::uint32_t y) {
  return ((x / 8) * 7 + (y / 8) * 3) % 8 == 0;
}

}  // namespace

ReportImages pictures() {
  const auto cachedVein = [](const Spot& spot, std::uint32_t x, std::uint32_t y) {
    return isMiss(x, y) ? marble(spot) : 0.97 * marble(spot) + 0.015 + 0.012 * std::sin(0.9 * x + 0.7 * y);
  };
  ReportImages images;
  images.original = png([](auto x, auto y) { return shaded(spotAt(x, y), marble(spotAt(x, y))); });
  images.cached = png([&](auto x, auto y) { return shaded(spotAt(x, y), cachedVein(spotAt(x, y), x, y)); });
  images.error = png([&](auto x, auto y) {
    const Spot spot = spotAt(x, y);
    const Rgb a = shaded(spot, marble(spot)), b = shaded(spot, cachedVein(spot, x, y));
    return Rgb{8 * std::abs(a[0] - b[0]), 8 * std::abs(a[1] - b[1]), 8 * std::abs(a[2] - b[2])};
  });
  images.hit_miss = png([](auto x, auto y) {
    if (!spotAt(x, y).covered) return Rgb{0.04, 0.05, 0.07};
    return isMiss(x, y) ? Rgb{0.816, 0.545, 0.173} : Rgb{0.184, 0.435, 0.31};
  });
  return images;
}

}  // namespace reprise::sample
