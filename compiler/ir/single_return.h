// A function brought to one return, at its end, so that a call of it can be replaced by its blocks.
//
// SPIR-V leaves a loop or a switch by its merge block alone. So a return within some stores its value and a flag, and leaves the
// innermost of them; where that one merges, the flag decides whether to leave the next. All of it stands in a switch of one case,
// whose merge block is the end:
//
//   bool returned = false;  T value;
//   switch (0) { default:
//     for (...) {                       for (...) {
//       if (c) return x;        ->        if (c) { value = x; returned = true; break; }
//     }                                 }
//                                       if (returned) break;
//     return y;                         value = y; break;
//   }                                 }
//                                     return value;
//
// Flags and values are local variables; promotion makes values of them (promote_variables.h). Flags are no candidates (return_flags.h).
#pragma once

#include <optional>

#include "compiler/ir/module.h"

namespace reprise {

// `function` has no unreachable blocks (unreachable_blocks.h) but those that must stay. Fresh ids, types and constants come from `module`.
// Nothing where that cannot be done: a return within the continue construct of a loop, which can be left by its back edge alone.
std::optional<Function> withSingleReturn(Module& module, const Function& function);

}  // namespace reprise
