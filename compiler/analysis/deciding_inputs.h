// Which inputs decide the way that a shader takes: how often its loops run, which case of a switch, which side of a branch.
//
// Followed through values, memory and control as in analyse.h, so an input that a loop's bound was computed from counts, too.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/analysis/analyse.h"

namespace reprise {

// A varying, or a range of a block's bytes: of a member where the shader reads one by its name, else all.
struct DecidingInput {
  enum class Kind { kVarying, kBlock, kPushConstants };
  Kind kind = Kind::kVarying;
  std::uint32_t location = 0, component = 0;  // of a varying
  std::uint32_t components = 1;               // of a varying: scalars of its vector
  bool is_integer = false;                    // of a varying; blocks may hold both
  std::uint32_t set = 0, binding = 0;         // of a block
  std::uint32_t first_byte = 0, end_byte = 0; // of a block
  bool operator==(const DecidingInput&) const = default;
};

// Those of loops' exits and of switches first, then those of branches; each once. Varyings that are scalars or vectors, members of uniform and
// storage blocks and push constants.
std::vector<DecidingInput> decidingInputs(const PreparedShader& shader, const ShaderAnalysis& analysis);

}  // namespace reprise
