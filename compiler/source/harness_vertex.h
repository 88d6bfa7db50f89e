// A vertex shader for a fragment shader that comes without one: it draws a mesh and gives every varying values that vary.
//
// Vertex inputs: vec3 position, vec3 normal, vec2 uv. One uniform block HarnessScene at binding 0 of the first set that the
// fragment shader leaves free: mat4 view_projection, mat4 model, uvec3 seed, uvec4 given[32]. gl_Position = view_projection * model *
// position. Every scalar of every varying is a smooth function of position, normal and uv with coefficients from the seed (x, y), in the
// range of style z. Integers are in 0..3; where the fragment shader has arrays of descriptors, which they may index, they are below the
// length of the shortest and the same for a whole draw. Number location * 4 + component is that word of `given` unless it is 0xffffffff.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "runtime/base/result.h"

namespace reprise {

// GLSL text. Errors: those of reflect.h; source.unsupported (kInput) for varyings that are not made of 16-, 32- or 64-bit numbers.
Result<std::string> harnessVertexText(std::span<const std::uint32_t> fragment_words);

}  // namespace reprise
