// NoContraction on every float operation of a module, the functions of GLSL.std.450 among them as `precise` has it in GLSL: the only edit that a reference may have (the design's law 0).
//
// The decorations are put into the words as they are, so that no reader or writer of ours comes between the module and the device.
// The instructions are those of compiler/ir/reproducible.h, which does the same for our side.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace reprise {

// words: a module that has passed the validator.
std::vector<std::uint32_t> withNoContraction(std::span<const std::uint32_t> words);

}  // namespace reprise
