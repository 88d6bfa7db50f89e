// When two images of one shader differ by rounding alone (the design's law 0).
//
// A difference is rounding only if it is little, and a witness says that the computation is the same: the bits agree once no operation
// may be fused (NoContraction on both sides), or the reference interpreter finds equal terms. Everything else is ours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace reprise {

// What a word of an image holds: the bits of a float, an integer, or a byte of an 8-bit target (0..255).
enum class ChannelKind { kFloat, kWhole, kByte };

inline constexpr double kRounding = 1e-5;       // times the larger of 1 and the value
inline constexpr double kSteppedPixels = 1e-3;  // share of the pixels of an 8-bit target that may be a step off

// kEqual: the same number (0 and -0 are, and one NaN is as good as another). kRounded: little. kBeyond: more than that.
enum class Nearness { kEqual, kRounded, kBeyond };

// Of two words. tolerance: of floats, times the larger of 1 and the first value; at 0 nothing is kRounded.
Nearness nearnessOf(std::uint32_t expected, std::uint32_t found, ChannelKind kind, double tolerance = kRounding);

struct ImageDifference {
  Nearness nearness = Nearness::kEqual;
  std::size_t pixels = 0;            // that are not equal
  std::optional<std::size_t> pixel;  // the first one that is as far off as `nearness` says
};

// Of two images, four words a pixel, of the same size. Of bytes more than kSteppedPixels that are a step off are kBeyond.
ImageDifference compareImages(std::span<const std::uint32_t> expected, std::span<const std::uint32_t> found, ChannelKind kind,
                              double tolerance = kRounding);

// What the reference interpreter says of two modules (kUnknown: it cannot read one of them).
enum class Computation { kSame, kDifferent, kUnknown };

struct Evidence {
  Nearness as_given = Nearness::kEqual;
  bool equal_without_contraction = false;  // bit for bit with NoContraction on both sides
  Computation interpreted = Computation::kUnknown;
};

enum class Judgement {
  kEqual,
  kRounded,   // little, and one witness
  kEnlarged,  // more than little, but both witnesses: the shader enlarges rounding errors itself
  kOurs
};
Judgement judge(const Evidence& evidence);

}  // namespace reprise
