// The vertex side of reprojection: where the vertex was in the last frame, computed by the user's own code.
//
// The entry function is cloned; in the clone every uniform block and the push constants are last frame's copies, and
// gl_Position is a private variable. The new main runs the original function, then the clone, and writes the previous clip
// position as (x, y, w) - or (x, y, z) for orthographic cameras - to a varying. A draw that was absent last frame gets a
// position outside every viewport, so that all of its pixels miss. (Nehab et al. 2007, section 3.1.)
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/ir/module.h"
#include "runtime/package/recipe.h"

namespace reprise {

struct PreviousPositionOptions {
  std::uint32_t reprise_set = 0;
  std::uint32_t location = 0;         // of the varying
  const Module* frame = nullptr;      // compiled glsl/previous_position.vert
};

struct PreviousPosition {
  Module module;
  std::vector<PreviousInput> inputs;  // what the slice of gl_Position reads, with its new bindings
};

// vertex: calls inlined (optimize.h), one entry point. Errors (kRefused): vertex.no_position (the shader writes no gl_Position),
// vertex.input (the position depends on a storage buffer or a texture, whose last content is not kept in version 1),
// vertex.block_use, variable.use.
Result<PreviousPosition> addPreviousPosition(const Module& vertex, const PreviousPositionOptions& options);

// The first location that no output of the vertex shader and no input of the fragment shader uses.
std::uint32_t firstFreeVarying(const Module& vertex, const Module& fragment);

}  // namespace reprise
