// What a payload saves: the cost of the shader less that of the tail, by the value graph.
#pragma once

#include <vector>

#include "compiler/candidates/enumerate.h"
#include "compiler/candidates/need_dominators.h"

namespace reprise {

struct WeighedPayload {
  double saved_cost = 0;
  double slice_cost = 0;
  bool slice_takes_derivatives = false;
  // The tail takes derivatives of what depends on the payload.
  bool tail_takes_derivatives = false;
};

// Values that a payload's regroupings leave to the tail are needed by it, and so is what decides whether guarded values are.
WeighedPayload weighPayload(const ShaderAnalysis& analysis, const std::vector<CandidateValue>& values);

// The same for one value that the shader needs, whole, with the dominators of analysis.graph: what takes one look at the shader less for each.
WeighedPayload weighSingle(const ShaderAnalysis& analysis, const NeedDominators& dominators, const CandidateValue& value);

// Whether every path from the entry to a normal end runs through the block.
bool isAlwaysRun(const ControlFlow& flow, const Function& function, int block);

}  // namespace reprise
