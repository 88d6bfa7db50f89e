// Dropping candidates that training need not look at: near-duplicates, dominated ones and those beyond a number.
#pragma once

#include <vector>

#include "compiler/candidates/enumerate.h"

namespace reprise {

// Marks candidates of a list that is ranked by saved_cost; never touches one that has a reason already. A heuristic: that
// a value which changes with fewer inputs is the steadier one holds unless the rest of the computation damps changes.
void pruneCandidates(std::vector<Candidate>& ranked, double shader_cost, const CandidateOptions& options);

}  // namespace reprise
