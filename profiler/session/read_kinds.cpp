#include "profiler/session/read_kinds.h"

#include <algorithm>
#include <cstring>

namespace reprise {
namespace {

// Of an integer from 0 to 255.
std::uint8_t byteOfHalf(std::uint16_t half) {
  const int exponent = half >> 10;
  return exponent < 15 ? 0 : static_cast<std::uint8_t>((0x400 | (half & 0x3ff)) >> (25 - exponent));
}

}  // namespace

bool tellsKinds(const Recipe& recipe) {
  return std::any_of(recipe.resources.begin(), recipe.resources.end(), [](const Resource& one) { return one.name == kKind || one.name == kKindAndAge; });
}

Result<PixelKinds> readKinds(Readback& readback, Commands& commands, const Player& player) {
  PixelKinds pixels;
  const auto both = player.resource(kKindAndAge), alone = player.resource(kKind);
  const auto& image = both ? both : alone;
  if (!image) return pixels;
  REPRISE_ASSIGN(const auto texels, readback.read(commands, {image->image, image->format, image->extent, image->layout}));
  if (!both) {
    pixels.kind.resize(texels.size());
    std::memcpy(pixels.kind.data(), texels.data(), texels.size());
    return pixels;
  }
  pixels.kind.resize(texels.size() / 4);
  pixels.age.resize(pixels.kind.size());
  for (std::size_t pixel = 0; pixel < pixels.kind.size(); ++pixel) {
    std::uint16_t halves[2];
    std::memcpy(halves, &texels[pixel * 4], sizeof halves);
    pixels.kind[pixel] = byteOfHalf(halves[0]);
    pixels.age[pixel] = byteOfHalf(halves[1]);
  }
  return pixels;
}

}  // namespace reprise
