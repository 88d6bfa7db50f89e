#include "profiler/metrics/rounding.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "runtime/base/check.h"

namespace reprise {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How far a channel is off: in its own units, and as a multiple of what it may be off.
struct Offset {
  Nearness nearness = Nearness::kEqual;
  double distance = 0, share = 0;
};

Offset offsetWithin(double distance, double allowed) {
  if (distance == 0) return {};
  return {distance <= allowed ? Nearness::kRounded : Nearness::kBeyond, distance, allowed > 0 ? distance / allowed : kInfinity};
}

Offset floatOffset(std::uint32_t expected_word, std::uint32_t found_word, double tolerance) {
  if (expected_word == found_word) return {};
  const double expected = static_cast<double>(std::bit_cast<float>(expected_word)), found = static_cast<double>(std::bit_cast<float>(found_word));
  if (expected == found || (std::isnan(expected) && std::isnan(found))) return {};
  if (!std::isfinite(expected) || !std::isfinite(found)) return {Nearness::kBeyond, kInfinity, kInfinity};
  return offsetWithin(std::abs(expected - found), tolerance * std::max(1.0, std::abs(expected)));
}

Offset offsetOf(ChannelKind kind, std::uint32_t expected, std::uint32_t found, double tolerance) {
  if (kind == ChannelKind::kFloat) return floatOffset(expected, found, tolerance);
  return offsetWithin(std::abs(static_cast<double>(expected) - static_cast<double>(found)), kind == ChannelKind::kUnorm8 ? 1 : 0);
}

}  // namespace

Nearness nearnessOf(std::uint32_t expected, std::uint32_t found, ChannelKind kind, double tolerance) {
  return offsetOf(kind, expected, found, tolerance).nearness;
}

RoundingVerdict compareImages(const ImagePair& pair, double tolerance) {
  REPRISE_CHECK(pair.expected.size() == pair.found.size() && pair.expected.size() % 4 == 0, pair.expected.size(), pair.found.size());
  const std::size_t pixels = pair.expected.size() / 4;
  REPRISE_CHECK(pair.left_out == nullptr || pair.left_out->size() == pixels, pixels);
  RoundingVerdict verdict;
  std::size_t compared = 0;
  double worst = 0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    if (pair.left_out != nullptr && (*pair.left_out)[pixel]) continue;
    ++compared;
    // Most pixels.
    if (std::equal(pair.expected.begin() + static_cast<std::ptrdiff_t>(pixel * 4), pair.expected.begin() + static_cast<std::ptrdiff_t>(pixel * 4 + 4),
                   pair.found.begin() + static_cast<std::ptrdiff_t>(pixel * 4)))
      continue;
    Offset most;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const Offset one = offsetOf(pair.kind, pair.expected[pixel * 4 + channel], pair.found[pixel * 4 + channel], tolerance);
      if (one.share > most.share) most = one;
    }
    if (most.nearness == Nearness::kEqual) continue;
    ++verdict.differing;
    verdict.beyond += most.nearness == Nearness::kBeyond ? 1 : 0;
    if (most.share <= worst) continue;
    worst = most.share;
    verdict.pixel = pixel;
    verdict.largest = most.distance;
  }
  if (verdict.differing == 0) return verdict;
  const bool too_many = pair.kind == ChannelKind::kUnorm8 && static_cast<double>(verdict.differing) > kMostPixelsOneStepOff * static_cast<double>(compared);
  verdict.nearness = verdict.beyond > 0 || too_many ? Nearness::kBeyond : Nearness::kRounded;
  return verdict;
}

std::vector<std::uint32_t> unorm8Of(std::span<const std::uint32_t> float_words) {
  std::vector<std::uint32_t> steps(float_words.size());
  std::transform(float_words.begin(), float_words.end(), steps.begin(), [](std::uint32_t word) {
    const float value = std::bit_cast<float>(word);
    return std::isnan(value) ? 0u : static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
  });
  return steps;
}

}  // namespace reprise
