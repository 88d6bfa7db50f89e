// What may pass for rounding between two words, or two images of one moment (law 0). A float may be off by 1e-5 of the larger of 1 and
// the value expected; of targets of 8 bits a channel 0.1% of the pixels may be off by one step; integers not at all. Zeros of either sign are
// the same value, and so are all NaNs. Being that close is needed and not enough: whoever asks must also have a witness (the bits
// agree with NoContraction on both sides, or an interpreter finds the same computation).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace reprise {

inline constexpr double kRoundingTolerance = 1e-5;
inline constexpr double kMostPixelsOneStepOff = 0.001;  // as a share

enum class ChannelKind {
  kFloat,   // words are the bits of floats of 32 bits
  kUnorm8,  // words are 0 to 255
  kInteger  // words are compared as they are
};

// kRounded: no more than rounding may be. Later is worse.
enum class Nearness { kEqual, kRounded, kBeyond };

// Of two words. tolerance: of floats, relative to max(1, |expected|); at 0 none is kRounded. It replaces kRoundingTolerance where a law
// has a wider one.
Nearness nearnessOf(std::uint32_t expected, std::uint32_t found, ChannelKind kind, double tolerance = kRoundingTolerance);

// Four words a pixel, rows from the top; both have the same size.
struct ImagePair {
  std::span<const std::uint32_t> expected, found;
  ChannelKind kind = ChannelKind::kFloat;
  const std::vector<bool>* left_out = nullptr;  // by pixel: not compared
};

struct RoundingVerdict {
  Nearness nearness = Nearness::kEqual;
  std::size_t differing = 0;  // pixels with any difference
  std::size_t beyond = 0;     // pixels off by more than the tolerance; of kUnorm8 by more than a step
  std::size_t pixel = 0;      // the one that is off most, in units of what it may be off; 0 where none is
  double largest = 0;         // how far it is off, in the values' own units; infinity where one of the two is no number
};

// tolerance: as nearnessOf has it.
RoundingVerdict compareImages(const ImagePair& pair, double tolerance = kRoundingTolerance);

// Floats' bits as a target of 8 bits would hold them: clamped to [0, 1], rounded to the nearest of 255 steps; NaN is 0.
std::vector<std::uint32_t> unorm8Of(std::span<const std::uint32_t> float_words);

}  // namespace reprise
