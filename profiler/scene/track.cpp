#include "profiler/scene/track.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "profiler/scene/lattice_noise.h"

namespace reprise {
namespace {

std::vector<float> evaluateKeyFrames(const KeyFramesTrack& track, double time_s) {
  const auto next = std::upper_bound(track.times_s.begin(), track.times_s.end(), time_s);
  if (next == track.times_s.begin()) return track.values.front();
  if (next == track.times_s.end()) return track.values.back();
  const auto index = static_cast<std::size_t>(next - track.times_s.begin());
  const double start_s = track.times_s[index - 1];
  const double part = (time_s - start_s) / (track.times_s[index] - start_s);
  std::vector<float> values = track.values[index - 1];
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] =
        static_cast<float>(values[i] + part * (static_cast<double>(track.values[index][i]) - values[i]));
  }
  return values;
}

std::vector<float> evaluateOscillation(const OscillationTrack& track, double time_s) {
  const double swing = std::sin(2 * std::numbers::pi * time_s / track.period_s + track.phase_rad);
  std::vector<float> values = track.base;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(values[i] + track.amplitude[i] * swing);
  return values;
}

// Reflects a coordinate at the ends of [-extent, extent], as often as needed.
double foldInto(double value, double extent) {
  if (extent <= 0) return 0;
  const double period = 4 * extent;
  double phase = std::fmod(value + extent, period);
  if (phase < 0) phase += period;
  return phase <= 2 * extent ? phase - extent : 3 * extent - phase;
}

// The offset from base of one component.
double walkOffset(const RandomWalkTrack& track, std::size_t component, double time_s, std::uint32_t seed) {
  const double extent = track.extent[component];
  const double position = time_s / kWalkKnot_s;
  const auto span = static_cast<std::uint64_t>(position);
  const double part = position - static_cast<double>(span);
  // Control points span, span + 1 and span + 2 shape this span; points 0 and 1 lie at base.
  double points[3] = {0, 0, 0};
  double offset = 0;
  for (std::uint64_t knot = 2; knot <= span + 2; ++knot) {
    const double random = latticeRandom(static_cast<std::int32_t>(knot), static_cast<std::int32_t>(component),
                                        track.seed ^ (seed * 0x9e3779b9u));
    offset = foldInto(offset + (2 * random - 1) * track.step_per_s * kWalkKnot_s, extent);
    points[0] = points[1];
    points[1] = points[2];
    points[2] = offset;
  }
  const double first = 0.5 * (1 - part) * (1 - part), last = 0.5 * part * part;
  return first * points[0] + (1 - first - last) * points[1] + last * points[2];
}

std::vector<float> evaluateWalk(const RandomWalkTrack& track, double time_s, std::uint32_t seed) {
  std::vector<float> values = track.base;
  for (std::size_t i = 0; i < values.size(); ++i) {
    // Adding in float may round past the bound by the last bit.
    const float low = track.base[i] - track.extent[i], high = track.base[i] + track.extent[i];
    values[i] = std::clamp(static_cast<float>(track.base[i] + walkOffset(track, i, time_s, seed)), low, high);
  }
  return values;
}

std::vector<float> evaluateFlicker(const FlickerTrack& track, double time_s, std::uint32_t seed) {
  // A time that is a multiple of 1/rate_hz but for its rounding belongs to the draw that begins there.
  const double draw = std::fmod(std::floor(time_s * track.rate_hz + 1e-6), 1 << 30);
  const double swing = 2 * latticeRandom(static_cast<std::int32_t>(draw), 0, track.seed ^ (seed * 0x9e3779b9u)) - 1;
  std::vector<float> values = track.base;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(values[i] + track.amplitude[i] * swing);
  return values;
}

}  // namespace

std::vector<float> evaluateTrack(const Track& track, double time_s, std::uint32_t seed) {
  const double at_s = std::max(0.0, time_s);
  if (const auto* fixed = std::get_if<FixedTrack>(&track)) return fixed->value;
  if (const auto* keys = std::get_if<KeyFramesTrack>(&track)) return evaluateKeyFrames(*keys, at_s);
  if (const auto* oscillation = std::get_if<OscillationTrack>(&track))
    return evaluateOscillation(*oscillation, at_s);
  if (const auto* flicker = std::get_if<FlickerTrack>(&track)) return evaluateFlicker(*flicker, at_s, seed);
  return evaluateWalk(std::get<RandomWalkTrack>(track), at_s, seed);
}

}  // namespace reprise
