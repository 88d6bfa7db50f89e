// TOML → Scenario, with diagnostics that say file, line, column, what was found, what was expected, and near names.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "profiler/scenario/scenario.h"
#include "runtime/base/result.h"
#include "runtime/package/interface.h"

namespace reprise {

// Relative paths in the file are resolved against its directory. Errors (kInput, with place): scenario.syntax,
// scenario.unknown_key, scenario.missing_key, scenario.type, scenario.value (a period of 0 or not a power of two, a negative
// size, no training session, ...), scenario.missing_file.
Result<Scenario> readScenario(const std::filesystem::path& path);

// TOML text that reads back to the same Scenario (law 6), paths made relative to `directory` where they lie below it.
std::string writeScenario(const Scenario& scenario, const std::filesystem::path& directory);

// Calls the vertex inputs as 'vertex_inputs' of [shader] says; what it does not name keeps its name. Names there that the shader lacks are
// told by checkBindings.
void nameVertexInputs(const Scenario& scenario, ShaderInterface& interface);

// Holds the bindings against the shaders: every uniform-block and push-constant member bound exactly once and of a fitting
// size, every texture given, every vertex input one of position, normal, tangent, uv, color (after nameVertexInputs). Errors (kInput, with place):
// scenario.unbound (nobody binds it), scenario.unknown_uniform, scenario.unknown_texture (the shader lacks it; near names),
// scenario.vertex_input, scenario.outputs (colour formats and outputs differ in number), scenario.unsupported, scenario.pass_order
// (a pass reads a texture before that is rendered). passes: the interface of each G-buffer pass, by pass.
Result<void> checkBindings(const Scenario& scenario, const ShaderInterface& interface, std::span<const ShaderInterface> passes = {});

}  // namespace reprise
