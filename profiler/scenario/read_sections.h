// The sections of a scenario file, one function each. All add what is wrong to the diagnostics.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "profiler/scenario/table_reader.h"

namespace reprise {

// `name`: letters, digits, '_', '-' and '.', as it becomes part of file names.
void readName(TableReader& reader, std::string& name);

// A path against `directory`, normal and absolute. Reports scenario.missing_file at `node` where there is
// none.
std::string resolvePath(const TomlNode& node, const std::filesystem::path& directory, bool is_directory,
                        Diagnostics& diagnostics);

void readShader(const TomlNode& node, const std::filesystem::path& directory, Scenario& scenario,
                Diagnostics& diagnostics);
void readRender(const TomlNode& node, Scenario& scenario, Diagnostics& diagnostics);
std::vector<UniformBinding> readUniforms(const TomlNode& node, Diagnostics& diagnostics);
TextureSpec readTexture(const TomlNode& node, const std::filesystem::path& directory, Diagnostics& diagnostics);

// Overrides are held against the objects and uniforms of `scenario`, which must be read before.
SessionSpec readSession(const TomlNode& node, const Scenario& scenario, Diagnostics& diagnostics);

}  // namespace reprise
