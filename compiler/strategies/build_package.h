// A variant and the original beside it as one package: what ships, and what an application plays where the variant cannot be.
#pragma once

#include "compiler/strategies/build_recipe.h"
#include "runtime/package/package.h"

namespace reprise {

// Errors: those of buildRecipe.
Result<Package> buildPackage(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options,
                             const StateLimits& limits);

}  // namespace reprise
