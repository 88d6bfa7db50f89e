// The vertex shader of a scenario that names none: moved, skinned and morphed as the object needs.
//
//   p = position + sum of morph_weights[i] * morph_position_i; if joint_count > 0: p = (sum of weights[j] * joint_matrices[joints[j]]) * p
//   world = model * p, gl_Position = view_projection * world
// The fragment shader takes by name (of "input.uv" the last part), at the locations that it declares: world_position (vec3), world_normal (vec3, not normalized),
// world_tangent (vec4, w: handedness), object_position (vec3, before morphing and skinning), object_normal (vec3), uv (vec2), color (vec4).
// Uniform blocks StandardFrame, StandardObject, StandardSkin, StandardMorph lie in the first set that the fragment shader leaves free.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "runtime/base/result.h"

namespace reprise {

// What the objects of a scene need; 0: none of it is in the shader.
struct StandardVertexOptions {
  std::size_t joints = 0;         // of the largest skin
  std::size_t morph_targets = 0;  // most of a mesh, up to 4
};

// GLSL text. Errors (kInput): those of reflect.h; source.varying, an input that is none of those above or of another type.
Result<std::string> standardVertexText(std::span<const std::uint32_t> fragment_words, const StandardVertexOptions& options);

}  // namespace reprise
