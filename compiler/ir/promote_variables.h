// Local variables promoted to SSA values.
//
//   int a = 0;                            loop: a1 = phi(0 from entry, a2 from next)
//   for (...) if (c) a = f(a);      ->          ... a2 = phi(a1 from head, f(a1) from then)
//
// After Cytron, Ferrante, Rosen, Wegman, Zadeck, "Efficiently Computing Static Single Assignment Form and the Control Dependence
// Graph" (1991): phis at the iterated dominance frontiers of the stores, only where the variable is live, then renaming in a walk of
// the dominator tree. Our own, because SPIRV-Tools' --ssa-rewrite (2023.1) gives wrong values for some nested loops with break and
// continue.
//
// Values of vectors and matrices of which a part is stored become an insertion into the value so far; reads of a part, an extraction. A
// variable stays in memory where an array or a struct of it is indexed (split_variables.h leaves only what must stay), where it is
// accessed as volatile, or where something else than loads and stores uses its address. What is read before it was stored is
// undefined (OpUndef). A phi has the name of its variable, and is RelaxedPrecision where the variable is.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

// Of one function, whose blocks are all reachable but for those that must stay (unreachable_blocks.h).
Module promoteVariables(const Module& module, std::uint32_t function);

}  // namespace reprise
