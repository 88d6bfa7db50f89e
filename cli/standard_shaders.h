// The shaders of a scenario that names none (docs/scenario.md, "Standard shaders").
#pragma once

#include "compiler/source/compile.h"
#include "profiler/scenario/scenario.h"

namespace reprise {

// Metallic-roughness, with what the scenario's models need. Errors: those of compile.
Result<CompiledShader> standardFragment(const Scenario& scenario);

// For that fragment shader or the user's. Errors: those of standard_vertex.h.
Result<CompiledShader> standardVertex(const Scenario& scenario, const CompiledShader& fragment);

}  // namespace reprise
