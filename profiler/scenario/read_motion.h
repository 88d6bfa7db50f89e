// The parts of a scenario that move: tracks and motions of objects; and the meshes that they move. All
// add what is wrong to the reader's diagnostics.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "profiler/scenario/table_reader.h"

namespace reprise {

// A track from `node`: a number, an array of numbers, or a table with `value`, `key_frames`, `oscillate`,
// `random_walk` or `flicker`. components: how many floats it must yield, 0 for any number of them. `what` names it in
// messages.
std::optional<Track> readTrack(const TomlNode& node, const std::string& what, std::size_t components,
                               Diagnostics& diagnostics);

// A key that holds a track of three values, or a direction (three numbers that are not all 0).
void readTrackAt(TableReader& reader, const std::string& key, Track& track, Need need = Need::kOptional);
void readDirection(TableReader& reader, const std::string& key, std::array<float, 3>& direction);

Motion readMotion(const TomlNode& node, const std::string& what, Diagnostics& diagnostics);
MeshSpec readMesh(const TomlNode& node, const std::string& what, Diagnostics& diagnostics);

}  // namespace reprise
