// Why a strategy cannot be had for a shader, a payload and the application's state.
#pragma once

#include <optional>

#include "compiler/strategies/build_recipe.h"

namespace reprise {

bool isEarlyTests(const Instruction& execution_mode);

// Whether not all fragments are drawn at the depth of their triangle.
bool decidesDepth(const ShaderProgram& program);

// Whether passes reject a part of a quad while the shader's derivatives depend on what it reads from storage buffers: each lane of the quad must read
// them then, also the rejected ones. (Misses that go on beside hits are rejected at the end of their pass; hits by early tests of the next.)
bool needsRejectedLanes(const Strategy& strategy, const ShaderProgram& program);

// The refusal (kRefused), with the codes that buildRecipe lists; nothing if this tells of none: transforms may refuse still. A strategy
// that does not cache is not refused here. options.strategy is in the registry.
std::optional<Error> refuseVariant(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options,
                                   const StateLimits& limits);

}  // namespace reprise
