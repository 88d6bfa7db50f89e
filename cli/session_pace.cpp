#include "cli/session_pace.h"

#include <cmath>

#include "cli/fit.h"
#include "fitting/selection/pace.h"

namespace reprise {

SessionPace paceAgainst(const std::vector<TimedFrame>& first, const std::vector<TimedFrame>& later) {
  const auto ratio = [&](double TimedFrame::*member) {
    const auto medianTime = [&](const std::vector<TimedFrame>& frames) {
      std::vector<double> times;
      for (const TimedFrame& frame : frames) times.push_back(frame.*member);
      return medianOf(std::move(times));
    };
    const double value = paceOf({medianTime(first), 1}, {medianTime(later), 1});
    return std::isfinite(value) ? value : 1;
  };
  return {ratio(&TimedFrame::clock_ms), ratio(&TimedFrame::wall_ms)};
}

std::vector<TimedFrame> atPace(std::vector<TimedFrame> frames, const SessionPace& pace) {
  for (TimedFrame& frame : frames) {
    frame.clock_ms /= pace.clock;
    frame.wall_ms /= pace.wall;
  }
  return frames;
}

}  // namespace reprise
