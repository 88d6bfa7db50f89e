#include "profiler/scene/lattice_noise.h"

#include <cmath>

namespace reprise {
namespace {

// Finalizer of MurmurHash3 (Appleby): every bit of the result depends on every bit of the argument.
std::uint32_t scramble(std::uint32_t bits) {
  bits ^= bits >> 16;
  bits *= 0x85ebca6bu;
  bits ^= bits >> 13;
  bits *= 0xc2b2ae35u;
  return bits ^ (bits >> 16);
}

std::int32_t wrapped(std::int32_t cell, std::int32_t period) {
  if (period <= 0) return cell;
  const std::int32_t rest = cell % period;
  return rest < 0 ? rest + period : rest;
}

double smooth(double part) {
  return part * part * (3 - 2 * part);
}

}  // namespace

double latticeRandom(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  const std::uint32_t column = scramble(static_cast<std::uint32_t>(x) + 0x9e3779b9u * seed);
  const std::uint32_t bits = scramble(static_cast<std::uint32_t>(y) ^ (column * 0x85ebca77u + seed));
  return bits / 4294967296.0;
}

double valueNoise(double x, double y, std::uint32_t seed, std::int32_t period) {
  const double floor_x = std::floor(x), floor_y = std::floor(y);
  const auto cell_x = static_cast<std::int32_t>(floor_x), cell_y = static_cast<std::int32_t>(floor_y);
  const double blend_x = smooth(x - floor_x), blend_y = smooth(y - floor_y);
  const auto at = [&](std::int32_t dx, std::int32_t dy) {
    return latticeRandom(wrapped(cell_x + dx, period), wrapped(cell_y + dy, period), seed);
  };
  const double low = at(0, 0) + blend_x * (at(1, 0) - at(0, 0));
  const double high = at(0, 1) + blend_x * (at(1, 1) - at(0, 1));
  return low + blend_y * (high - low);
}

double fractalNoise(double x, double y, std::uint32_t seed, std::int32_t period) {
  double sum = 0, weight = 0.5, scale = 1;
  std::int32_t octave_period = period;
  for (std::uint32_t octave = 0; octave < 4; ++octave) {
    sum += weight * valueNoise(x * scale, y * scale, seed + octave, octave_period);
    weight /= 2;
    scale *= 2;
    octave_period *= 2;
  }
  return sum / 0.9375;
}

}  // namespace reprise
