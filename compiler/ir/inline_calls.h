// Calls replaced by the blocks of what they call.
//
//   float f(float x) { ... return y; }          a = ...;
//   a = ...; b = f(a); c = b + 1.0;      ->     <blocks of f, x = a>; c = y + 1.0;
//
// Functions are first brought to one return (single_return.h). No instruction is folded or reordered: what is computed, and in which
// order, stays (law 1). Copies carry the names, lines and decorations of what they copy; locals of a callee become locals of the
// caller, and an initializer becomes a store where the call stood, as it takes effect at each call. Private variables that only one
// entry point uses become locals, too (private_variables.h).
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// All calls of the entry points' functions, at every depth; other functions are dropped.
// A call stays where SPIR-V has no place for the blocks: of a function that returns from the continue construct of a loop, or that
// discards and is called from one; of one that calls itself; and in a loop header that branches two ways into its loop.
// Errors: shader.limit (kRefused) where the result has more of something than module_limits.h allows.
Result<Module> inlineCalls(const Module& module);

}  // namespace reprise
