// The source with the share of cost of each line and the candidates in the margin.
#pragma once

#include <ostream>
#include <vector>

#include "compiler/candidates/enumerate.h"
#include "compiler/source/compile.h"

namespace reprise {

struct AnnotatedShader {
  const PreparedShader& shader;
  const ShaderAnalysis& analysis;
  const std::vector<Candidate>& candidates;
  const std::vector<SourceFile>& sources;  // files without cost and candidates are left out
};

void printAnnotated(const AnnotatedShader& annotated, std::ostream& out);

// "1st of 3: a hit saves 97.9% of the cost; 1 channel; changes with varying place"
std::string rankText(const Candidate& candidate, std::size_t rank, std::size_t count, const ShaderAnalysis& analysis);

}  // namespace reprise
