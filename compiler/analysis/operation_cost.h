// What one SPIR-V instruction costs, in units of one scalar addition.
//
// A static table in the manner of shader compilers' instruction counts: it ranks candidates before anything is measured and
// decides nothing that training could. Wrong, by design, where the memory system decides (texture fetches), and for
// whatever a driver folds away.
#pragma once

#include <cstdint>

#include "compiler/ir/module.h"

namespace reprise {

// components: of the result, or of the operand for reductions such as OpDot. >= 0.
double operationCost(const Instruction& instruction, int components);

// True for operations whose result depends on neighbouring pixels of the quad: implicit-LOD samples and derivatives.
bool takesImplicitDerivative(spv::Op opcode);
// True for operations that change memory, or end or demote the invocation.
bool hasSideEffect(spv::Op opcode);
// Extraction, construction, conversion of shape: moves values and computes none.
bool onlyRearranges(spv::Op opcode);

}  // namespace reprise
