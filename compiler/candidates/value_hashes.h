// What a value is, whatever its id and wherever its line: a hash of the structure of its slice.
//
// hash(node) = H(opcode, type, decorations that change results, literals, and for each operand:
//                a constant's type and value; an input's name; another node's hash;
//                the hashes of the branches that decide whether it is computed, and the side taken)
// Ids, lines, names of locals and the order of independent instructions do not count. Uniform blocks count by the names of the
// members that are read, so that members may be added. Where loops lead back to a node that has no hash yet, that of the pass
// before stands for it; after kHashPasses passes every node of a loop's body has had its say.
#pragma once

#include <string>
#include <vector>

#include "compiler/analysis/analyse.h"
#include "compiler/ir/prepare.h"

namespace reprise {

inline constexpr int kHashPasses = 3;

// By node of analysis.graph: 32 hexadecimal digits. `with_constants` false gives the shape: all constants of a type are alike.
std::vector<std::string> hashValues(const PreparedShader& shader, const ShaderAnalysis& analysis, bool with_constants = true);

}  // namespace reprise
