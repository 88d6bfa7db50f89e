// Pseudo-random numbers of the points of an integer lattice, and smooth noise through them. The same on every
// machine: integer arithmetic alone decides them.
#pragma once

#include <cstdint>

namespace reprise {

// In [0, 1), from the point and a seed.
double latticeRandom(std::int32_t x, std::int32_t y, std::uint32_t seed);

// Value noise in [0, 1): latticeRandom at the lattice points, smoothstep-interpolated between them. If period
// > 0, the lattice repeats after that many cells along both axes.
double valueNoise(double x, double y, std::uint32_t seed, std::int32_t period);

// Four octaves of valueNoise, each of half the size and half the height of the last; in [0, 1).
double fractalNoise(double x, double y, std::uint32_t seed, std::int32_t period);

}  // namespace reprise
