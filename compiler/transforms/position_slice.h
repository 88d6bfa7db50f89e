// The slice of gl_Position in a vertex shader, and what it reads: where the motion comes from that reprojection follows.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "compiler/ir/module.h"

namespace reprise {

// A copy of the entry function from which all is gone that gl_Position does not need. The copy writes the position to `slot`, an output
// of its own, and no other output; it is an entry point, `reprise_prior`, so that it stays.
struct PositionSlice {
  Module module;
  std::uint32_t function = 0, slot = 0;  // ids of the copy and of the variable that it writes
  std::uint32_t output = 0;              // the variable that holds the shader's own gl_Position
};

// vertex: calls inlined (optimize.h), one entry point. Errors (kRefused): vertex.no_position (the shader writes no gl_Position),
// variable.use.
Result<PositionSlice> slicePosition(const Module& vertex);

// The ids that a function's instructions name.
std::unordered_set<std::uint32_t> idsUsedBy(const Function& function);

// kOther: storage buffers, texel buffers, textures and arrays of blocks, whose content cannot be told from the shader.
enum class PositionSource { kUniformBlock, kPushConstants, kOther };

struct ByteRange {
  std::uint32_t offset = 0, size = 0;
  bool operator==(const ByteRange&) const = default;
};

struct PositionInput {
  PositionSource source = PositionSource::kOther;
  std::string name;                    // the block's, or the variable's where it is no block
  std::uint32_t set = 0, binding = 0;  // of a descriptor
  std::vector<ByteRange> read;         // kUniformBlock, kPushConstants: of the members that are read, each once, by offset
};

// What the position depends on besides the vertex's own attributes and index. Empty: it is the same in every frame, and nothing that a
// pixel shows is followed by it. Errors: those of slicePosition.
Result<std::vector<PositionInput>> positionInputs(const Module& vertex);

}  // namespace reprise
