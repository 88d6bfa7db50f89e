#include "cli/check/frame_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace reprise {
namespace {

constexpr double kLeastCoverage = 0.1, kLeastFinite = 0.5;
constexpr std::uint32_t kClearDepth = 0x3f800000u;  // 1.0f

float asFloat(std::uint32_t word) { return std::bit_cast<float>(word); }

bool same(std::uint32_t a, std::uint32_t b, ChannelKind kind, double tolerance) { return nearnessOf(a, b, kind, tolerance) != Nearness::kBeyond; }

using ColorWords = std::vector<std::uint32_t>;

bool samePixel(const ColorWords& a, const ColorWords& b, std::size_t pixel, ChannelKind kind, double tolerance) {
  for (std::size_t channel = 0; channel < 4; ++channel)
    if (!same(a[pixel * 4 + channel], b[pixel * 4 + channel], kind, tolerance)) return false;
  return true;
}

std::string pixelText(const ColorWords& words, std::size_t pixel) {
  std::string text;
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const std::uint32_t word = words[pixel * 4 + channel];
    text += fmt::format("{}{} (0x{:08x})", channel == 0 ? "" : ", ", asFloat(word), word);
  }
  return text;
}

}  // namespace

bool covered(const HarnessFrame& frame, std::size_t pixel) { return frame.depth[pixel] != kClearDepth; }

std::optional<Violation> findViolation(const HarnessFrame& original, const HarnessFrame& played, const ColorLaw& law) {
  for (std::size_t pixel = 0; pixel < original.depth.size(); ++pixel) {
    if (!same(original.depth[pixel], played.depth[pixel], ChannelKind::kFloat, law.computed_depth ? law.tolerance : 0))
      return Violation{"law.depth", pixel, fmt::format("depth {}", asFloat(original.depth[pixel])), fmt::format("depth {}", asFloat(played.depth[pixel]))};
    const bool counted = !played.kind.empty() && played.kind[pixel] != 0;
    if (!played.kind.empty() && covered(original, pixel) != counted && (counted || law.depth_tells_coverage))
      return Violation{"law.books", pixel, covered(original, pixel) ? "a hit or a miss" : "nothing drawn", fmt::format("kind {}", played.kind[pixel])};
    if (law.left_out != nullptr && (*law.left_out)[pixel]) continue;
    if (law.pixels == ExactPixels::kMisses && (played.kind.empty() || played.kind[pixel] != 2)) continue;
    for (std::size_t output = 0; output < original.colors.size(); ++output)
      if (!samePixel(original.colors[output], played.colors[output], pixel, output < law.kinds.size() ? law.kinds[output] : ChannelKind::kFloat, law.tolerance))
        return Violation{law.name, pixel, fmt::format("output {}: {}", output, pixelText(original.colors[output], pixel)),
                         pixelText(played.colors[output], pixel)};
  }
  return std::nullopt;
}

bool sameColors(const HarnessFrame& a, const HarnessFrame& b, double tolerance, const std::vector<bool>* left_out) {
  for (std::size_t output = 0; output < a.colors.size(); ++output)
    for (std::size_t pixel = 0; pixel < a.depth.size(); ++pixel)
      if ((left_out == nullptr || !(*left_out)[pixel]) && !samePixel(a.colors[output], b.colors[output], pixel, ChannelKind::kFloat, tolerance)) return false;
  return true;
}

std::vector<ChannelKind> channelKinds(const std::vector<FragmentOutput>& outputs) {
  std::vector<ChannelKind> kinds;
  for (const FragmentOutput& output : outputs) kinds.push_back(output.scalar == ScalarKind::kFloat ? ChannelKind::kFloat : ChannelKind::kInteger);
  return kinds;
}

Meaning meaningOf(const HarnessFrame& original, const std::vector<FragmentOutput>& outputs, const std::vector<bool>* left_out) {
  std::size_t drawn = 0, finite = 0;
  bool varies = false;
  std::optional<std::size_t> first;
  for (std::size_t pixel = 0; pixel < original.depth.size(); ++pixel) {
    if (!covered(original, pixel) || (left_out != nullptr && (*left_out)[pixel])) continue;
    ++drawn;
    bool all_finite = true;
    for (std::size_t output = 0; output < outputs.size(); ++output) {
      if (outputs[output].scalar != ScalarKind::kFloat) continue;
      for (int channel = 0; channel < std::min(outputs[output].components, 4); ++channel)
        all_finite = all_finite && std::isfinite(asFloat(original.colors[output][pixel * 4 + static_cast<std::size_t>(channel)]));
    }
    if (!all_finite) continue;
    ++finite;
    if (!first) first = pixel;
    for (const auto& color : original.colors)
      varies = varies || std::memcmp(&color[pixel * 4], &color[*first * 4], 16) != 0;
  }
  if (static_cast<double>(drawn) < kLeastCoverage * static_cast<double>(original.depth.size()))
    return {Showing::kNothing, fmt::format("the shader covers {} of {} pixels", drawn, original.depth.size())};
  if (static_cast<double>(finite) < kLeastFinite * static_cast<double>(drawn))
    return {Showing::kNothing, fmt::format("{} of {} covered pixels are not finite", drawn - finite, drawn)};
  if (varies) return {};
  return {Showing::kConstant, "the image is the same everywhere"};
}

std::size_t countKind(const HarnessFrame& frame, std::uint8_t kind) {
  return static_cast<std::size_t>(std::count(frame.kind.begin(), frame.kind.end(), kind));
}

}  // namespace reprise
