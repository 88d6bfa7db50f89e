// Whether a shader's made-up inputs lead it into loops that do not end by themselves: it is nothing to compare with then.
#pragma once

#include "compiler/source/compile.h"
#include "profiler/harness/harness.h"
#include "runtime/base/result.h"
#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/context.h"

namespace reprise {

// More than this many iterations in one invocation count as endless; lavapipe stops all loops after 65,535.
inline constexpr std::uint32_t kEndlessIterations = 60000;

// Plays the shader with the made-up inputs, and a copy that ends its loops after so many iterations: true if a frame shows
// another image (by more than 1e-3 of the value). False without loops. Errors: those of the harness.
Result<bool> loopsEndlessly(const CompiledShader& fragment, const HarnessOptions& inputs, const Context& context, Commands& commands);

}  // namespace reprise
