// What training found, as values: error curves, hit rates and frame times of the variants that were measured.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/strategies/build_recipe.h"
#include "fitting/selection/select.h"
#include "profiler/measurements/row.h"
#include "profiler/measurements/store.h"
#include "profiler/metrics/error_limits.h"
#include "profiler/scenario/scenario.h"

namespace reprise {

// One way to keep one candidate, strategy aside: its errors hold for all strategies (law 11).
struct ErrorStudy {
  std::size_t candidate = 0;  // index into Subject::candidates
  VariantOptions options;     // of the instrumented variant that was rendered
  std::map<std::uint32_t, std::map<std::string, std::vector<ErrorRow>>> rows;  // by period, then session
  std::string failure;        // why there are no rows
};

struct TimedFrame {
  int frame = 0;
  double clock_ms = 0, wall_ms = 0;  // of the binding clock; of the wall
};

struct CostStudy {
  std::size_t error_study = 0;  // index into Training::errors
  std::string strategy;
  // By period, then session. Times of a session's later runs, and the reference beside them, are brought to the pace of its first
  // run by what the original took in both; ratios are those that were measured.
  std::map<std::uint32_t, std::map<std::string, std::vector<TimedFrame>>> frames;
  // By session: the faster of the original and the original with a prepass in the same rounds.
  std::map<std::string, std::vector<TimedFrame>> reference = {};
  std::string failure;
};

struct Training {
  std::vector<ErrorStudy> errors;
  std::vector<CostStudy> costs;
  std::vector<TimedFrame> original, prepass;        // over the first runs of all timed sessions
  std::map<std::size_t, std::vector<TimedFrame>> limits;  // tail-only, by candidate
  std::map<std::size_t, ValueRanges> ranges;        // by candidate
  std::map<std::size_t, ChannelFloats> changes;     // by candidate: the most that a channel changed at a pixel from one probed frame to the next
  std::vector<std::string> warnings, not_reached;
  std::map<std::size_t, std::string> failed;        // candidate -> why
  std::map<std::size_t, FailureRow> convicted;      // candidate -> where its package differs from the original (cli/hold_laws.h)
  bool budget_ended = false;                        // before all that was planned was measured
  std::map<std::string, std::string> strategies_refused;  // by this shader or state: strategy -> why
};

// Error of a session's rows by metric: combined as the metric has it (metrics.h) over all frames from 2 x period on (from frame 2 on for
// "never"). nullopt where no frame is left. Frames that the pattern
// makes wholly due are computed as the original is and left out: of stereo pairs the right eyes count.
std::optional<double> sessionError(const std::string& metric, const std::vector<const std::vector<ErrorRow>*>& sessions,
                                   std::uint32_t period_frames, PatternKind pattern = PatternKind::kInterleaved);

// The same of several metrics with their thresholds, in the unit of the limits.
std::optional<double> sessionError(const ErrorLimits& limits, const std::vector<const std::vector<ErrorRow>*>& sessions,
                                   std::uint32_t period_frames, PatternKind pattern = PatternKind::kInterleaved);

// Of a single frame; nullopt where it has no finite value.
std::optional<double> frameError(const ErrorLimits& limits, const ErrorRow& row);

// The frame's part in sessionError.
bool countsForError(int frame, std::uint32_t period_frames, PatternKind pattern);

// Times of eyes (frames 2k and 2k + 1) as those of pairs: in place of the two their mean, under the frame of the right eye. Single
// eyes are left out.
std::vector<TimedFrame> pairedEyes(const std::vector<TimedFrame>& frames);

// How many images `moments` are: two of each in stereo.
int imagesOf(const Scenario& scenario, int moments);

// The time that no variant of a payload can beat: that of its tail alone, with a payload that costs nothing. Of a pair of eyes one is computed
// as the original is, so it is the mean of both.
double limitFrameTime(const Scenario& scenario, double original_ms, double tail_ms);

// Frames before this one are still under the influence of the all-miss start.
int firstSettledFrame(std::uint32_t period_frames);

double medianOf(std::vector<double> values);  // NaN if empty

}  // namespace reprise
