// Whether strategies that draw again only the objects with misses are worth timing: the share of objects that have any, in 16 frames of each
// training session at a quarter of the resolution, never refreshed by age (stereo: in right eyes). It is the least there can be: a refresh adds
// misses. What such a strategy can save is the geometry of the other objects, at the price of a second rendering and of early depth
// rejection, which is a quarter of the frame on lavapipe (docs/decisions.md); so it is timed only where a quarter of the objects at least has none.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "cli/progress.h"
#include "cli/subject.h"
#include "cli/workspace.h"
#include "profiler/training/measure.h"

namespace reprise {

inline constexpr double kMostObjectsWithMisses = 0.75;

struct ObjectProbe {
  std::size_t candidate = 0;  // index into Subject::candidates
  ValueRanges ranges;
};

// The selectable strategies of that kind that are not worth timing, or that the device cannot play, each with the reason. What is refused by
// shader or state, or fails, is not among them: what times it says so. Errors: kInterrupted and kMachine.
Result<std::map<std::string, std::string>> strategiesWithoutIdleObjects(const Subject& subject, const Workspace& workspace, const Measuring& measuring,
                                                                        const ObjectProbe& probe, Progress& progress);

}  // namespace reprise
