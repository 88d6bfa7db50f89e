#include "profiler/scenario/track_size.h"

namespace reprise {

std::size_t trackSize(const Track& track) {
  if (const auto* fixed = std::get_if<FixedTrack>(&track)) return fixed->value.size();
  if (const auto* keys = std::get_if<KeyFramesTrack>(&track))
    return keys->values.empty() ? 0 : keys->values.front().size();
  if (const auto* oscillation = std::get_if<OscillationTrack>(&track)) return oscillation->base.size();
  if (const auto* flicker = std::get_if<FlickerTrack>(&track)) return flicker->base.size();
  return std::get<RandomWalkTrack>(track).base.size();
}

}  // namespace reprise
