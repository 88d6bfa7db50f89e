// What `check` takes from a request and a module before anything is played.
#pragma once

#include <vector>

#include "cli/check/verdict.h"
#include "compiler/candidates/enumerate.h"
#include "compiler/strategies/build_recipe.h"
#include "runtime/vulkan/context.h"

namespace reprise {

CompileOptions compileOptionsOf(const CheckRequest& request);

// Those that are kept, the best one first; regrouped chains last, as their hits equal the original but for rounding, which a shader may
// make much of. Error: candidate.none (kRefused), with the reason that most values have.
Result<std::vector<Candidate>> candidatesOf(const ShaderProgram& program);

// What the harness allows, and the device where it matters to the shader. Errors: those of probeLanes.
Result<StateLimits> limitsFor(const ShaderProgram& program, const Context& context);

// Undefined values made zero (compiler/ir/reproducible.h). Errors: those of readModule and validateModule.
Result<CompiledShader> withZeros(const CompiledShader& shader);

}  // namespace reprise
