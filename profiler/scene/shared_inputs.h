// Whether the objects of a scenario share what their fragment shader reads besides its varyings: what strategies ask that finish the
// pixels of all objects in one draw (StateLimits::shared_inputs).
#pragma once

#include "profiler/scenario/scenario.h"
#include "runtime/package/interface.h"

namespace reprise {

// True for one object. Of several, false where the fragment shader reads a block or push constants that hold anything of an object's own
// (model, normal_matrix, what models fill, in members that it may not read itself), or a texture of each object's material.
bool drawsShareInputs(const Scenario& scenario, const ShaderInterface& interface);

}  // namespace reprise
