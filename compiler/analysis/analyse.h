// What every value of a shader depends on, and what the shader as a whole does that matters to caching.
//
// Inputs are what the value changes with: varyings, built-ins, members of uniform blocks and push constants, textures,
// buffers. They follow data, memory and control dependences through loops to a fixed point.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/divergence.h"
#include "compiler/analysis/value_graph.h"
#include "compiler/ir/prepare.h"
#include "compiler/source/compile.h"
#include "runtime/base/result.h"

namespace reprise {

enum class InputKind { kVarying, kBuiltIn, kUniform, kTexture, kBuffer };
const char* nameOf(InputKind kind);  // "varying", "built-in", "uniform", "texture", "buffer"

struct InputSource {
  InputKind kind = InputKind::kVarying;
  std::string name;  // "normal", "FragCoord", "Scene.camera_position", "albedo_map"
  bool operator==(const InputSource&) const = default;
};

// Where an input stands in the prepared module.
struct InputOrigin {
  std::uint32_t variable = 0;
  std::optional<std::uint32_t> member;  // of a uniform block or the push constants; none where all may be read
};

// Inputs are kept by value, so their number times that of the instructions is memory.
inline constexpr std::size_t kMostInputs = 1024;

struct ShaderAnalysis {
  ValueGraph graph;
  std::vector<InputSource> inputs;
  std::vector<InputOrigin> origins;          // by input; of several of one name the first
  std::vector<std::vector<int>> inputs_of;   // by node: ascending indices into `inputs`
  std::vector<bool> live;                    // by node: needed by the shader as it is
  double total_cost = 0;                     // of the live nodes
  bool takes_derivatives = false;            // live implicit-LOD samples or derivatives
  std::vector<bool> differentiated;          // by node: a live implicit-LOD sample or derivative depends on it
  bool derivatives_read_buffers = false;     // one of those is a read of a storage buffer (buffer_reads.h)
  Divergence divergence;                     // derivatives whose lanes may have parted
  std::vector<bool> decides_coverage;        // by node: which fragments are discarded, or their depth, depends on it
  bool discards = false;                     // or demotes, or writes the sample mask
  // Why no variant of this shader can be made, if so: shader.side_effects, shader.subgroup, shader.interlock,
  // shader.sample_rate, shader.helper_invocation, shader.limit (more than kMostInputs inputs).
  std::optional<Error> refusal;
};

// The prepared shader must outlive the analysis, which points into it.
ShaderAnalysis analyse(const PreparedShader& shader);

// Where the value of an instruction comes from: the place of its assignment if it has a name, else of the instruction. The column, which
// glslang does not record, is where the name first stands in that line of `sources`, 0 if the file is not among them.
Place placeOf(const PreparedShader& shader, const Instruction& instruction, const std::vector<SourceFile>& sources);

}  // namespace reprise
