// Why a strategy cannot be had for a shader, a payload and the application's state.
#pragma once

#include <optional>

#include "compiler/strategies/build_recipe.h"

namespace reprise {

bool isEarlyTests(const Instruction& execution_mode);

// Whether not all fragments are drawn at the depth of their triangle.
bool decidesDepth(const ShaderProgram& program);

// The refusal (kRefused), with the codes that buildRecipe lists; nothing if this tells of none: transforms may refuse still. A strategy
// that does not cache is not refused here. options.strategy is in the registry.
std::optional<Error> refuseVariant(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options,
                                   const StateLimits& limits);

}  // namespace reprise
