// Times of a session's later runs brought to the pace of its first: a machine that others use too does the same work in another time from one
// minute to the next, and what was timed at another minute is ranked beside it all the same.
//   pace = median(reference frame times of the later run) / median(those of the first run)
#pragma once

#include <vector>

#include "cli/trained.h"

namespace reprise {

// How much longer the reference took than in the first run; 1 where a run has no times.
struct SessionPace {
  double clock = 1, wall = 1;
};

SessionPace paceAgainst(const std::vector<TimedFrame>& first, const std::vector<TimedFrame>& later);
std::vector<TimedFrame> atPace(std::vector<TimedFrame> frames, const SessionPace& pace);

}  // namespace reprise
