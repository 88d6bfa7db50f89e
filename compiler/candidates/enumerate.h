// Every value of a shader as a possible payload: kept as a candidate, or dropped for a stated reason. Beside the values as
// they stand: several values at once (groups.h) and parts of sums, products, minima and maxima (partials.h).
//
// saved_cost = cost of the live shader - cost of what is still needed when the payload is given (value_graph.h). It is the
// cost that a hit avoids, before the lookup is paid for. Ranked by saved_cost, largest first; ties by program order, so
// the order is deterministic and a shorter list is a prefix of a longer one (law 9).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/analyse.h"
#include "compiler/analysis/chains.h"
#include "compiler/ir/payload_type.h"
#include "compiler/ir/prepare.h"
#include "runtime/package/recipe.h"

namespace reprise {

// Reasons, in the order in which they are tested:
//   type.unsupported     not a scalar or vector that a payload can carry (payload_type.h)
//   place.loop           computed inside a loop: one pixel has many of it
//   value.uniform        depends on no varying and no built-in: the same all over the screen
//   value.rearranged     a load, an extraction or a composition of other values
//   value.coverage       what is discarded, or the fragment's depth, depends on it: a kept value would move edges
//   pruned.many          beyond kMostWeighed values that are left
//   tail.derivative      the rest of the shader takes derivatives of what depends on it
//   pruned.cheap         saves less than CandidateOptions::least_share of the shader's cost
//   pruned.channels      several values that save too little more than fewer do
//   pruned.duplicate     another candidate saves the same within same_cost_share, and is smaller or changes with less
//   pruned.dominated     another candidate saves at least as much, changes with no more inputs and needs no more channels
//   pruned.rank          beyond the CandidateOptions::most best ones, or the best of its kind
struct DropReason {
  std::string code;     // "" for a kept candidate
  std::string message;
};

// One of the values of a payload.
struct CandidateValue {
  std::uint32_t value = 0;       // result id in the prepared module; of a regrouped chain its root's
  int node = kNoNode;            // of `value`
  std::string name;              // as in the source; "" where it has none
  std::string operation;         // "FMul", "ImageSampleImplicitLod"
  std::string type;              // "float", "ivec3"
  PayloadScalar scalar = PayloadScalar::kFloat;
  int channels = 1;              // 1..4; 0: values of this type cannot be kept
  int first_channel = 0;
  int guard_channel = kNoGuard;  // of a value that is computed on some paths only: tells whether it was
  std::optional<Regrouping> regrouping;  // not the value itself is kept but the kept terms of its chain
  Place place;
};

// A possible payload. Text fields tell of all its values: "albedo + gloss", "vec3 + float"; `place` is the first one's.
struct Candidate {
  std::string id;               // stable: name or operation and place: "albedo@marble.frag:31"
  std::string name;             // as in the source; "" where it has none
  std::string operation;        // "FMul", "ImageSampleImplicitLod"
  std::string type;             // "float", "ivec3"
  PayloadScalar scalar = PayloadScalar::kFloat;  // of the first value: all are floats or all are integers
  int channels = 1;             // 1..kMostPayloadChannels, guards included
  std::vector<CandidateValue> values;
  Place place;
  double saved_cost = 0;
  double share = 0;             // saved_cost / the shader's cost, 0..1
  double slice_cost = 0;        // of computing the value alone
  std::vector<int> inputs;      // indices into ShaderAnalysis::inputs
  bool conditional = false;     // computed on some paths only: guarded
  bool slice_takes_derivatives = false;
  // A part of a chain that is kept although the whole saves more: what is left to the tail keeps its error small.
  bool steadier_part = false;
  DropReason dropped;
  bool kept() const { return dropped.code.empty(); }
};

// Weighing visits the whole shader for each value: so many keep the longest shader within seconds.
inline constexpr std::size_t kMostWeighed = 1000;

struct CandidateOptions {
  double least_share = 0.05;
  double same_cost_share = 0.01;
  // What each channel more than another candidate's has to save; a group saves more with every value, but a texel costs, too.
  double least_share_per_channel = 0.03;
  std::size_t most = 12;
  std::size_t most_groups = 4;  // of several values
  std::size_t most_partials = 4;
  std::size_t most_without_heaviest = 2;  // parts of chains that leave out the heaviest term
};

// All values with a result in the shader's live code, candidates first. Empty kept list: nothing is worth caching.
std::vector<Candidate> enumerateCandidates(const PreparedShader& shader, const ShaderAnalysis& analysis,
                                           const std::vector<SourceFile>& sources, const CandidateOptions& options);

// A value of a payload that somebody names: a node of the graph, or for a regrouping its chain's root.
struct WantedValue {
  int node = kNoNode;
  std::optional<Regrouping> regrouping;
};

// The payload of just these values, in this order, weighed and with channels as enumerateCandidates gives them; without an id.
// Dropped where it cannot be kept safely, but not for being cheap, dominated or one of many.
Candidate candidateOf(const PreparedShader& shader, const ShaderAnalysis& analysis, const std::vector<SourceFile>& sources,
                      const std::vector<WantedValue>& wanted);

// Whether what is kept is a part of a chain, so that hits equal the original but for rounding (transforms/regroup.h).
bool isRegrouped(const Candidate& candidate);

// "varying normal", "uniform Scene.camera_position", ... of a candidate.
std::vector<std::string> inputNames(const Candidate& candidate, const ShaderAnalysis& analysis);

}  // namespace reprise
