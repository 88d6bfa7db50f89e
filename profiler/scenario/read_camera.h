// A session's camera: its path (orbit, eye and target, recording or camera of a model), its lens, its shake and its cuts.
#pragma once

#include <filesystem>
#include <string>

#include "profiler/scenario/table_reader.h"

namespace reprise {

// What is wrong is added to the diagnostics. Recordings are looked for in `directory`.
Camera readCamera(const TomlNode& node, const std::string& what, const std::filesystem::path& directory, Diagnostics& diagnostics);

}  // namespace reprise
