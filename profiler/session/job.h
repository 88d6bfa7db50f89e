// What a measuring process is asked to do, and what it answers. A job is a plain value with a JSON form; the supervisor
// writes it to the worker's standard input and reads one JSON line per event from its standard output.
//
// All packages of a job are played in the same process on one device, from the same scenario and session. Jobs are
// deterministic in all but times (laws 8, 9).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "profiler/measurements/row.h"
#include "profiler/scenario/scenario.h"
#include "runtime/base/result.h"
#include "runtime/package/recipe.h"

namespace reprise {

struct JobEntry {
  std::string package_dir;          // a package whose `variant` is played
  std::uint32_t period_frames = 1;
  // kLaws: how far colours of hits may be off, relative to the larger of 1 and the value, without a witness; 0: not at all. For payloads
  // that are kept with less than all their bits, such as regrouped sums.
  double tolerance = 0;
  // kErrors: what a displayed channel may differ by, the rest is cut off; 0: nothing is. For finding out what metrics make of small
  // differences (bench/quality_levels).
  double most_difference = 0;
  bool operator==(const JobEntry&) const = default;
};

enum class JobKind {
  kErrors,  // per frame: the original once, then every entry (instrumented packages); rows of errors and counts
  kTimes,   // per round: every entry in turn, the same frame; uninstrumented packages; rows of times
  kProbe,   // entries are rgba32f packages: ranges of payload and depth, non-finite values
  kObjects, // entries flag their draws: how many objects have misses
  kImages,  // one frame of each entry as PNG files
  kReference,  // no entries: the colours of the original in lawFrames (law_frames.h) go to reference_dir
  kLaws     // entries at their exact setting, and frozen at one moment, against what kReference left in reference_dir
};

struct Job {
  JobKind kind = JobKind::kErrors;
  std::string scenario_path;
  std::string session;
  std::string original_dir;                 // package of the original
  std::vector<JobEntry> entries;
  std::vector<std::string> metrics;         // kErrors: names; besides the cheap ones
  int frames = 0;                           // kErrors, kProbe, kObjects: number of frames from 0; 0: the session's
  int rounds = 20;                          // kTimes: after warm-up
  int warmup_frames = 4;
  std::uint32_t width = 0, height = 0;      // 0: the scenario's
  std::string device;                       // name or index as `reprise devices` prints it; empty: the first
  int image_frame = 0;                      // kImages
  std::string image_dir;
  std::vector<int> strip_frames;            // kImages: further frames of the original and the first entry, ascending
  std::string reference_dir;                // kReference, kLaws
  double fence_timeout_s = 20;
  std::string run_id;
  bool operator==(const Job&) const = default;
};

struct ProbeResult {
  int entry = 0;
  ChannelFloats payload_min = {}, payload_max = {};
  // The most that a channel changed at a pixel from one probed frame to the next, of up to 16384 pixels that are evenly spread.
  ChannelFloats payload_change = {};
  float depth_min = 0, depth_max = 0;       // view-linear, over all covered pixels
  // Covered pixels that hold no valid payload, as it is not finite there.
  std::uint64_t nonfinite_payload = 0;
  std::uint64_t nonfinite_color = 0;        // pixels of the original, rendered to float targets whatever the scenario's are
  std::uint64_t covered = 0;
};

// Summed over the frames after the first in which draws are flagged; pairs of eyes flag in right ones.
struct ObjectCounts {
  std::uint64_t drawn = 0, flagged = 0;
  bool operator==(const ObjectCounts&) const = default;
};

inline constexpr const char* kExactSetting = "law.exact_setting";
inline constexpr const char* kFrozenWorld = "law.frozen_world";

// Where an entry differs from the original: the pixel of an image that is off most.
struct LawDifference {
  std::string law;                               // kExactSetting or kFrozenWorld
  int frame = 0;                                 // of the session
  int output = 0;
  std::uint32_t x = 0, y = 0;
  std::array<std::uint32_t, 4> expected = {}, found = {};  // bits of floats
  int kind = -1;                                 // 0 not drawn, 1 a hit, 2 a miss; -1 where the entry does not count
  std::uint64_t pixels = 0;                      // that differ in this image
  bool visible = true;                           // in the scenario's own format, where that has 8 bits
  bool operator==(const LawDifference&) const = default;
};

// What kLaws found of an entry. It is looked at no further once it differs by more than rounding (profiler/metrics/rounding.h).
struct LawOutcome {
  std::optional<LawDifference> difference;       // beyond rounding
  std::optional<LawDifference> rounding;         // the first that may be rounding, before all a visible one; wants a witness if visible
  std::uint64_t frozen_hits = 0;                 // pixels that hit while the scene was frozen; 0 where the entry does not count
  bool operator==(const LawOutcome&) const = default;
};

struct JobResult {
  std::string device, driver;
  bool cpu_device = false;                       // decides the binding clock: process CPU time, else timestamps
  std::vector<std::vector<ErrorRow>> errors;     // by entry
  std::vector<std::vector<TimeRow>> times;       // by entry; times[e][r] of round r
  std::vector<ProbeResult> probes;               // by entry
  std::vector<ObjectCounts> objects;             // by entry
  std::vector<LawOutcome> laws;                  // by entry
  // kImages: paths written: original.png, then per entry cached, error (kImageErrorGain times the difference), hit_miss and payload.
  // An entry that does not count, or has no cache, lacks the last ones. strip_N_original and strip_N_cached as frame N is reached.
  std::vector<std::string> images;
};

inline constexpr float kImageErrorGain = 8;

// Colours of the hit/miss image that kImages writes; uncovered pixels are grey.
inline constexpr const char* kHitColorText = "#2a9d4b";
inline constexpr const char* kMissColorText = "#d1495b";

struct JobProgress {
  int done = 0, total = 0;  // frames or rounds
};

// Runs a job in this process. Errors: device.none, device.lost, device.timeout, ... (kMachine or kMeasurement).
Result<JobResult> runJob(const Job& job, const std::function<void(const JobProgress&)>& progress);

// Runs a job in a worker process (`worker_path worker`, this executable) and survives its death: a crash is
// worker.crashed, silence beyond the time-out worker.timeout (kMeasurement). SIGINT: kInterrupted.
struct SupervisorOptions {
  std::string worker_path;
  double silence_timeout_s = 60;
  std::function<bool()> interrupted;  // polled; true ends the worker and the job: kInterrupted
  std::function<bool()> expired;      // the same, where the job's time is over: run.budget (kInterrupted), and nothing of the job is kept
};
inline constexpr const char* kBudgetEnded = "run.budget";
Result<JobResult> superviseJob(const Job& job, const SupervisorOptions& options,
                               const std::function<void(const JobProgress&)>& progress);

// The worker's side: reads a job from standard input, answers on standard output. Returns the exit status.
int runWorker();

std::string jobToJson(const Job& job);
Result<Job> jobFromJson(const std::string& text);

}  // namespace reprise
