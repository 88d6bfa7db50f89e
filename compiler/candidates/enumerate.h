// Every value of a shader as a possible payload: kept as a candidate, or dropped for a stated reason.
//
// saved_cost = cost of the live shader - cost of what is still needed when the value is given (value_graph.h). It is the
// cost that a hit avoids, before the lookup is paid for. Ranked by saved_cost, largest first; ties by program order, so
// the order is deterministic and a shorter list is a prefix of a longer one (law 9).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/analysis/analyse.h"
#include "compiler/ir/payload_type.h"
#include "compiler/ir/prepare.h"

namespace reprise {

struct DropReason {
  std::string code;     // "" for a kept candidate
  std::string message;
};

// Reasons, in the order in which they are tested:
//   type.unsupported     not a scalar or vector that a payload can carry (payload_type.h)
//   place.loop           computed inside a loop: one pixel has many of it
//   value.uniform        depends on no varying and no built-in: the same all over the screen
//   value.rearranged     a load, an extraction or a composition of other values
//   tail.derivative      the rest of the shader takes derivatives of what depends on it
//   pruned.cheap         saves less than CandidateOptions::least_share of the shader's cost
//   pruned.duplicate     another candidate saves the same within same_cost_share, and is smaller or changes with less
//   pruned.dominated     another candidate saves at least as much, changes with no more inputs and needs no more channels
//   pruned.rank          beyond the CandidateOptions::most best ones
struct Candidate {
  std::uint32_t value = 0;      // result id in the prepared module
  int node = kNoNode;
  std::string id;               // stable: name or operation and place: "albedo@marble.frag:31"
  std::string name;             // as in the source; "" where it has none
  std::string operation;        // "FMul", "ImageSampleImplicitLod"
  std::string type;             // "float", "ivec3"
  PayloadScalar scalar = PayloadScalar::kFloat;
  int channels = 1;             // 1..4
  Place place;
  double saved_cost = 0;
  double share = 0;             // saved_cost / the shader's cost, 0..1
  double slice_cost = 0;        // of computing the value alone
  std::vector<int> inputs;      // indices into ShaderAnalysis::inputs
  bool conditional = false;     // computed on some paths only: pixels that take another path always miss
  bool slice_takes_derivatives = false;
  DropReason dropped;
  bool kept() const { return dropped.code.empty(); }
};

struct CandidateOptions {
  double least_share = 0.05;
  double same_cost_share = 0.01;
  std::size_t most = 12;
};

// All values with a result in the shader's live code, candidates first. Empty kept list: nothing is worth caching.
std::vector<Candidate> enumerateCandidates(const PreparedShader& shader, const ShaderAnalysis& analysis,
                                           const std::vector<SourceFile>& sources, const CandidateOptions& options);

// "varying normal", "uniform Scene.camera_position", ... of a candidate.
std::vector<std::string> inputNames(const Candidate& candidate, const ShaderAnalysis& analysis);

}  // namespace reprise
