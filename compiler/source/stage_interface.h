// What one module declares towards its neighbours, before the two stages are put together (reflect.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/source/compile.h"
#include "compiler/source/reflect.h"
#include "runtime/package/interface.h"

namespace reprise {

// One location of a stage's inputs or outputs; matrices, arrays and blocks take several.
struct StageSlot {
  std::uint32_t location = 0;
  std::uint32_t component = 0;
  std::string type;  // "float", "ivec2", "dvec3"
  std::string name;
  bool operator==(const StageSlot&) const = default;
};

struct StageInterface {
  std::vector<StageSlot> inputs;           // that the code refers to
  std::vector<StageSlot> outputs;          // all that are declared
  std::vector<VertexInput> vertex_inputs;  // by location; of a vertex module
  std::vector<FragmentOutput> colors;      // by location; of a fragment module
  std::vector<Descriptor> descriptors;
  std::string push_constant_name;
  std::vector<PushConstantRange> push_constants;  // none or one
  std::vector<BlockMember> push_constant_members;
  bool writes_depth = false;
  bool discards = false;
};

// Errors: source.unsupported, source.invalid.
Result<StageInterface> reflectStage(std::span<const std::uint32_t> words, ShaderStage stage, const ReflectOptions& options = {});

}  // namespace reprise
