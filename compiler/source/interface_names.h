// Names for what a module shows to its neighbours, so that it can be spoken of: in scenarios, reports and messages.
//
// SPIR-V of other compilers often lacks names (stripped modules), or has those of the compiler's own types. Given names stay;
// what has none gets one by its place, the same whatever else the module holds:
//   block_S_B         uniform and storage blocks at set S, binding B; push_constants for the push-constant block
//   texture_S_B       sampled images, with their sampler or alone; sampler_S_B samplers; image_S_B storage images
//   memberN           the member of index N of a block, or of a struct in it
//   input_L           vertex inputs at location L; varying_L what goes from stage to stage, output_L colour outputs;
//                     of a component C other than 0, input_L_C and so on
// A block bears the name of its variable where its type's is the compiler's own ("type.Scene", "Scene_std140") or several
// variables share the type. Vertex inputs are called by the last part of a dotted name ("input.normal"), and where that is a semantic
// of HLSL as meshes call it: POSITION position, NORMAL normal, TANGENT tangent, TEXCOORD0 uv, COLOR0 color.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace reprise {

// The module with these names; the very words where nothing is to be named. It must have passed the validator and have one entry point.
std::vector<std::uint32_t> withInterfaceNames(std::span<const std::uint32_t> words);

// Gives blocks and images that both stages have at one set and binding, and push constants, one name in both, that of the vertex
// module where both have one: blocks where one is the beginning of the other, by types and offsets.
void shareInterfaceNames(std::vector<std::uint32_t>& vertex, std::vector<std::uint32_t>& fragment);

}  // namespace reprise
