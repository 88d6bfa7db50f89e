// What a pair of shaders expects from its application, read from SPIR-V with SPIRV-Cross.
//
// Blocks bear the name of their type (`uniform Scene {...} scene;` is "Scene"), as in scenario files
// ("Scene.member"); the instance's name where the type has none. Images and samplers bear the variable's
// name. Members are flattened as interface.h says; offsets are those of the module. Only what the entry
// point's code statically refers to is listed. The stages must agree on a binding that both use, names of
// members included; one block may be the beginning of the other. Sizes of blocks are rounded up to 16 bytes.
// Push constants of both stages become one list of members; their ranges are one range with both stage bits
// where they overlap, so that a push of each range with its stages is always valid.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/result.h"
#include "runtime/package/interface.h"

namespace reprise {

struct ReflectOptions {
  // Members that interface.h cannot describe (64 bits) are left out instead of being an error; arrays without a size have 16 elements.
  bool skip_unknown_members = false;
  // Descriptor arrays without a size count as 16, arrays of arrays as one array.
  bool any_arrays = false;
  // Of descriptors of one kind that a stage declares at one binding the largest stands for all, and names need not differ: those
  // that bind by name do without.
  bool any_bindings = false;
};

// Both modules must have passed the validator and have one entry point of their stage. Errors (kInput):
//   source.interface    a fragment input without a vertex output of the same location, component and type, or
//                       a binding or push constant that the stages declare differently; says both
//   source.binding      two descriptors of one stage at one binding, that are not an image and its sampler; says both names
//   source.unsupported  what interface.h cannot describe: unsized or multi-dimensional descriptor arrays, input
//                       attachments, 16- and 64-bit members, matrix or 64-bit vertex inputs
//   source.stage        a module without an entry point of its stage
//   source.invalid      the module cannot be read
Result<ShaderInterface> reflectInterface(std::span<const std::uint32_t> vertex_words,
                                         std::span<const std::uint32_t> fragment_words, const ReflectOptions& options = {});

}  // namespace reprise
