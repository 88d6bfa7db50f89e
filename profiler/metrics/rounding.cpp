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
  double distance = 0, share = 0;
};

Offset floatOffset(std::uint32_t expected_word, std::uint32_t found_word, double tolerance) {
  if (expected_word == found_word) return {};
  const double expected = static_cast<double>(std::bit_cast<float>(expected_word)), found = static_cast<double>(std::bit_cast<float>(found_word));
  if (expected == found || (std::isnan(expected) && std::isnan(found))) return {};
  const double distance = std::abs(expected - found);
  if (!std::isfinite(expected) || !std::isfinite(found)) return {kInfinity, kInfinity};
  const double allowed = tolerance * std::max(1.0, std::abs(expected));
  return {distance, allowed > 0 ? distance / allowed : kInfinity};
}

Offset offsetOf(TexelKind kind, std::uint32_t expected, std::uint32_t found, double tolerance) {
  if (kind == TexelKind::kFloat) return floatOffset(expected, found, tolerance);
  const double distance = std::abs(static_cast<double>(expected) - static_cast<double>(found));
  if (kind == TexelKind::kUnorm8) return {distance, distance};
  return {distance, distance > 0 ? kInfinity : 0};
}

}  // namespace

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
    if (most.distance == 0) continue;
    ++verdict.differing;
    verdict.beyond += most.share > 1 ? 1 : 0;
    if (most.share <= worst) continue;
    worst = most.share;
    verdict.pixel = pixel;
    verdict.largest = most.distance;
  }
  if (verdict.differing == 0) return verdict;
  const bool too_many = pair.kind == TexelKind::kUnorm8 && static_cast<double>(verdict.differing) > kMostPixelsOneStepOff * static_cast<double>(compared);
  verdict.difference = verdict.beyond > 0 || too_many ? Difference::kBeyondRounding : Difference::kRounding;
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
