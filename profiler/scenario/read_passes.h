// The [[pass]] tables of a scenario, and uniform sources that name a pass.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "profiler/scenario/table_reader.h"

namespace reprise {

// After objects, models, uniforms and textures, which passes refer to or must not clash with.
void readPasses(TableReader& root, const std::filesystem::path& directory, Scenario& scenario);

// { pass_view_projection = "shadow_map" }; nothing, without a word, if `node` is no such table.
std::optional<PassSource> readPassSource(const TomlNode& node, const std::string& what, Diagnostics& diagnostics);

}  // namespace reprise
