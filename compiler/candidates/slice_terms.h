// What computes a value, as terms: operations of operations, down to inputs and constants. Ids, lines and names of locals are not in it.
//
// A head is "FMul:vec3", "Sin", "CompositeExtract.1" (an operation with its literals; the type where it is not float), "0.5", "3", "vec3"
// of constants, or an input by its name: "varying position", "uniform Frame.gain", "texture noise". A phi has the values that meet in it as
// parts, and then the branches that decide between them, so that the terms of a loop contain themselves. A value that branches decide on
// is the first part of a "When".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/analysis/analyse.h"
#include "compiler/analysis/chains.h"
#include "compiler/ir/prepare.h"

namespace reprise {

struct SliceTerm {
  std::string head;
  std::vector<int> parts = {};  // places in SliceTerms
  int node = kNoNode;           // of the graph; of a constant, and of terms that were read from text, none
};
using SliceTerms = std::vector<SliceTerm>;  // the first is the whole

// What a text that was cut off does not tell: equal to anything.
inline constexpr const char* kUnknownHead = "?";

bool isConstantHead(const std::string& head);  // of a single number or truth value
bool isInputHead(const std::string& head);     // "varying ", "built-in ", "uniform ", "texture ", "buffer "

SliceTerms termsOfValue(const PreparedShader& shader, const ShaderAnalysis& analysis, int node);
// The terms of a chain that are `kept`, as parts of its kind: "sum(a, minus(b))".
SliceTerms termsOfChain(const PreparedShader& shader, const ShaderAnalysis& analysis, const Chain& chain, const std::vector<bool>& kept);

}  // namespace reprise
