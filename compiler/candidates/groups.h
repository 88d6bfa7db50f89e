// Payloads of several values: the sets of values that save most for their channels, as minimum cuts of the value graph.
//
// Give every value v two vertices, v_in ("someone needs it") and v_out ("the tail computes it"). The outputs are computed; what
// is computed needs its operands; a needed value is computed unless the edge v_in -> v_out is cut, which keeps it, at gamma for
// each of its channels; an edge v_out -> sink costs v's own operations. A minimum cut is the set of values with the least
//   cost(tail) + gamma * channels,
// so as gamma falls the cuts run through the lower convex hull of tail cost over channels: for each channel count on the hull,
// no other set of values saves more. The breakpoints are found by intersecting the lines of known cuts (Eisner, Severance 1976,
// "Mathematical techniques for efficient record segmentation in large shared databases"). Sets off the hull are not seen.
//
// The search runs once with all values and once for each of the input sets of the best single values, with only those values that
// change with no more: what changes with the camera makes errors, however much it saves.
#pragma once

#include <vector>

#include "compiler/candidates/enumerate.h"

namespace reprise {

struct GroupOptions {
  int most_channels = static_cast<int>(kMostPayloadChannels);
  std::size_t most_input_sets = 3;
  std::size_t most_cuts = 10;  // for each input set
};

// Groups of two values or more, all floats, none computed in a loop, as lists of indices into `singles`, ascending. `singles` are
// the candidates of one value; only kept ones are grouped, in the order of their saved cost for the choice of input sets.
std::vector<std::vector<std::size_t>> findGroups(const ShaderAnalysis& analysis, const std::vector<Candidate>& singles,
                                                 const GroupOptions& options);

}  // namespace reprise
