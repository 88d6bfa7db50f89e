// How much of a shader's cost each source line has.
//
//   share(line) = sum of the costs of the live instructions on the line / the shader's cost
//
// Shares of all lines and of what has no line add up to 1. Inlined functions count on their own lines, in each call.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "compiler/analysis/analyse.h"

namespace reprise {

// By (file, line), shares in (0, 1]; line 0 stands for code without a place.
std::map<std::pair<std::string, int>, double> lineCosts(const PreparedShader& shader, const ShaderAnalysis& analysis);

}  // namespace reprise
