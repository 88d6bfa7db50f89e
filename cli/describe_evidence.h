// The source with its costs and cuts, and the frames behind the cost models, as the report shows them.
#pragma once

#include <string>
#include <vector>

#include "cli/fit.h"
#include "cli/report/evidence.h"
#include "cli/subject.h"
#include "cli/trained.h"

namespace reprise {

// Files that have a line with a cost, in the order of the shader's sources.
std::vector<EvidenceSource> describeSources(const ShaderProgram& program);

// The shader cut at each kept candidate. Of a regrouped chain the kept terms are the payload.
std::vector<EvidenceSlice> describeSlices(const ShaderProgram& program, const std::vector<Candidate>& candidates,
                                          const std::vector<EvidenceSource>& sources);

// Frames that were both timed and counted, by configuration.
std::vector<EvidenceCost> describeCosts(const Training& training, const FittedTraining& fitted);

}  // namespace reprise
