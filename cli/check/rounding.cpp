#include "cli/check/rounding.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "runtime/base/check.h"

namespace reprise {
namespace {

constexpr std::size_t kChannels = 4;

Nearness nearnessOfFloats(float expected, float found, double tolerance) {
  if (expected == found || (std::isnan(expected) && std::isnan(found))) return Nearness::kEqual;
  if (!std::isfinite(expected) || !std::isfinite(found)) return Nearness::kBeyond;
  const double difference = std::abs(static_cast<double>(expected) - static_cast<double>(found));
  return difference <= tolerance * std::max(1.0, std::abs(static_cast<double>(expected))) ? Nearness::kRounded : Nearness::kBeyond;
}

}  // namespace

Nearness nearnessOf(std::uint32_t expected, std::uint32_t found, ChannelKind kind, double tolerance) {
  if (expected == found) return Nearness::kEqual;
  switch (kind) {
    case ChannelKind::kFloat: return nearnessOfFloats(std::bit_cast<float>(expected), std::bit_cast<float>(found), tolerance);
    case ChannelKind::kWhole: return Nearness::kBeyond;
    case ChannelKind::kByte: return std::max(expected, found) - std::min(expected, found) <= 1 ? Nearness::kRounded : Nearness::kBeyond;
  }
  return Nearness::kBeyond;
}

ImageDifference compareImages(std::span<const std::uint32_t> expected, std::span<const std::uint32_t> found, ChannelKind kind, double tolerance) {
  REPRISE_CHECK(expected.size() == found.size(), expected.size());
  ImageDifference difference;
  for (std::size_t pixel = 0; pixel * kChannels < expected.size(); ++pixel) {
    Nearness worst = Nearness::kEqual;
    for (std::size_t at = pixel * kChannels; at < (pixel + 1) * kChannels; ++at)
      worst = std::max(worst, nearnessOf(expected[at], found[at], kind, tolerance));
    if (worst == Nearness::kEqual) continue;
    ++difference.pixels;
    if (worst <= difference.nearness) continue;
    difference.nearness = worst;
    difference.pixel = pixel;
  }
  const double all = static_cast<double>(expected.size() / kChannels);
  if (kind == ChannelKind::kByte && static_cast<double>(difference.pixels) > kSteppedPixels * all) difference.nearness = Nearness::kBeyond;
  return difference;
}

Judgement judge(const Evidence& evidence) {
  if (evidence.interpreted == Computation::kDifferent) return Judgement::kOurs;
  const bool same = evidence.interpreted == Computation::kSame;
  switch (evidence.as_given) {
    case Nearness::kEqual: return Judgement::kEqual;
    case Nearness::kRounded: return evidence.equal_without_contraction || same ? Judgement::kRounded : Judgement::kOurs;
    case Nearness::kBeyond: return evidence.equal_without_contraction && same ? Judgement::kEnlarged : Judgement::kOurs;
  }
  return Judgement::kOurs;
}

}  // namespace reprise
