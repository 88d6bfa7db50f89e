#include "profiler/scene/handheld.h"

#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "profiler/scene/lattice_noise.h"

namespace reprise {
namespace {

struct Wave {
  double frequency, share;
};
constexpr Wave kWaves[] = {{0.43, 0.5}, {1, 0.3}, {1.71, 0.2}};
constexpr int kNumbers = 6;

}  // namespace

Shake shakeAt(const Handheld& handheld, const Moment& moment) {
  const std::uint32_t seed = handheld.seed ^ (moment.seed * 0x9e3779b9u);
  float swings[kNumbers] = {};
  for (int i = 0; i < kNumbers; ++i) {
    double swing = 0;
    for (int w = 0; w < 3; ++w) {
      const double turns = kWaves[w].frequency * handheld.frequency_hz * moment.time_s + latticeRandom(i, w, seed);
      swing += kWaves[w].share * std::sin(2 * std::numbers::pi * turns);
    }
    swings[i] = static_cast<float>(swing);
  }
  return {handheld.move * glm::vec3(swings[0], swings[1], swings[2]),
          glm::radians(handheld.turn_deg) * glm::vec3(swings[3], swings[4], swings[5])};
}

}  // namespace reprise
