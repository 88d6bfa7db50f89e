// The parts of a scenario that move: tracks, motions of objects, cameras; and the meshes that they move. All
// add what is wrong to the reader's diagnostics.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "profiler/scenario/table_reader.h"

namespace reprise {

// A track from `node`: a number, an array of numbers, or a table with `value`, `key_frames`, `oscillate` or
// `random_walk`. components: how many floats it must yield, 0 for any number of them. `what` names it in
// messages.
std::optional<Track> readTrack(const TomlNode& node, const std::string& what, std::size_t components,
                               Diagnostics& diagnostics);

Motion readMotion(const TomlNode& node, const std::string& what, Diagnostics& diagnostics);
Camera readCamera(const TomlNode& node, const std::string& what, Diagnostics& diagnostics);
MeshSpec readMesh(const TomlNode& node, const std::string& what, Diagnostics& diagnostics);

}  // namespace reprise
