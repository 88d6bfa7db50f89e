// The range of each candidate's payload and of the history depth, seen in the training sessions: 12 frames of each at a quarter of the
// resolution, drawn by the branch strategy with a 32-bit float cache, which keeps every value as it is.
//
// What comes out is widened, for validation and applications go where training did not: payload by 5% of its span on each side, depth
// to half the nearest and 1.5 times the farthest that was seen, within the sessions' planes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/progress.h"
#include "cli/subject.h"
#include "cli/workspace.h"
#include "profiler/training/measure.h"

namespace reprise {

struct ProbedRanges {
  std::map<std::size_t, ValueRanges> ranges;   // by index into Subject::candidates
  std::map<std::size_t, ChannelFloats> changes;  // of the same: the most that a channel changed at a pixel between probed frames
  std::map<std::size_t, std::string> failed;   // the others that enumeration had kept, each with the reason
  std::vector<std::string> warnings;           // of payloads and colours that are not finite
};

// Errors: kInterrupted and kMachine; a probe that fails by itself is in `failed`.
Result<ProbedRanges> probeCandidates(const Subject& subject, const Workspace& workspace, const Measuring& measuring, Progress& progress);

// Where nothing has been probed: all of the depths between the sessions' planes, payloads in [0, 1].
ValueRanges unprobedRanges(const Subject& subject);

}  // namespace reprise
