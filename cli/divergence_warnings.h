// What is told of derivatives that lanes of a quad may reach apart (compiler/analysis/divergence.h).
#pragma once

#include <string>
#include <vector>

#include "compiler/analysis/analyse.h"

namespace reprise {

inline constexpr const char* kDivergentDerivative = "derivative.divergent";

struct DivergenceWarning {
  Place place;
  std::string message;  // a sentence without its place
};

// One for each place in the source, in the order of the code. Empty if there is nothing to warn of.
std::vector<DivergenceWarning> divergenceWarnings(const PreparedShader& shader, const ShaderAnalysis& analysis, const std::vector<SourceFile>& sources);

}  // namespace reprise
