// Short loops written out, so that their terms are values of their own: a filter's 25 samples, say.
#pragma once

#include <cstdint>

#include "compiler/ir/module.h"
#include "runtime/base/result.h"

namespace reprise {

inline constexpr int kMostUnrolledIterations = 32;
inline constexpr int kMostUnrolledInstructions = 1024;  // of a loop, written out, inner loops too
inline constexpr int kMostInstructionsUnrolledOnRequest = 4096;  // of one that its author marks [[unroll]]: drivers unroll it, too
// Of functions beyond these no loop is unrolled: looking for those that may be takes the product of both.
inline constexpr std::size_t kMostLoops = 64;
inline constexpr std::size_t kMostInstructionsToUnroll = 16384;

// Loops of constant trip count (trip_count.h) within these limits are replaced by their iterations, which keep their order; index
// arithmetic is folded. Other loops stay. Floats are left alone: what drivers fold they fold themselves (law 1). Errors:
// spirv.optimize.
Result<Module> unrollShortLoops(const Module& module, std::uint32_t function);

}  // namespace reprise
