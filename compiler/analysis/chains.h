// Chains of one associative operation: the trees of sums, products, minima and maxima that a shader's terms form.
//
// A chain is the largest tree of equal operations (FAdd with FSub; FMul; FMin or NMin; FMax or NMax) whose inner results are used
// once, by the tree itself; its terms are the leaves from left to right. Operations decorated NoContraction ("precise") are no
// links, since their order is the shader's will.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/ir/module.h"

namespace reprise {

struct ChainTerm {
  std::uint32_t value = 0;
  bool negative = false;  // in sums: subtracted
};

enum class ChainKind { kSum, kProduct, kMinimum, kMaximum };
const char* nameOf(ChainKind kind);  // "sum", "product", "minimum", "maximum"


struct Chain {
  ChainKind kind = ChainKind::kSum;
  std::uint32_t root = 0;  // the result of the whole chain
  std::vector<ChainTerm> terms;
};

// Every chain of at least three terms in a function, roots in program order.
std::vector<Chain> findChains(const Module& module, const Function& function);
// Where an operation of a chain has the two ids that it joins.
std::size_t firstOperand(const Instruction& operation);

// A chain split in two (transforms/regroup.h).
struct Regrouping {
  Chain chain;
  std::vector<bool> kept;  // by term; neither none nor all
};

}  // namespace reprise
