// The outcome of a run as plain values: everything that DIR/result.json holds and the report shows.
// docs/result.md describes the file for scripts; resultFromJson(resultToJson(r)) equals r.
//
// Units: times in milliseconds of the binding clock unless a name says wall; errors in the unit of
// `threshold.metric` (0 = identical); rates and shares in [0, 1]; speed-ups are original / variant (2 = twice
// as fast); lines and columns count from 1, 0 is unknown. A number that is not finite is written as null; a
// plain double reads null back as NaN. An empty std::optional or std::vector means "not measured" or "does
// not apply", and is null or [] in the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

// Grows when a reader of the old version would misread the new one; new keys alone do not count.
inline constexpr int kResultFormatVersion = 1;

// Periods: frames between two refreshes; kNeverRefresh (0, runtime/package/recipe.h) means never and is null
// in the file.

// The code that one warning begins with: that nothing moves by the vertex shader while the payload changes. It comes first in `warnings`, and
// before everything else in summaries and pages.
inline constexpr const char* kMotionSuspect = "motion.suspect";

// Whether pixels that are not drawn read storage buffers for their neighbours' derivatives (runtime/vulkan/lane_probe.h).
struct RunLanes {
  bool helper = true, rejected = true, discarded = true;
  bool operator==(const RunLanes&) const = default;
};

struct RunDevice {
  std::string name;    // as Vulkan reports it: "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string driver;  // name and version
  bool cpu = false;    // a CPU device: the binding clock is process CPU time
  std::string host;    // processor and number of cores; may be empty
  std::optional<RunLanes> lanes = std::nullopt;  // of runs that looked
  bool operator==(const RunDevice&) const = default;
};

struct RunShader {
  std::string fragment;  // paths as the user gave them
  std::string vertex;
  std::string hash;  // of the compiled modules
  bool operator==(const RunShader&) const = default;
};

struct RunScenario {
  std::string path, name, hash;
  std::uint32_t width = 0, height = 0;
  std::uint32_t seed = 0;
  int frames = 0;  // of the training sessions together
  std::optional<double> eye_distance;  // of stereo scenarios, in units of the world; frame times are those of one eye then
  bool operator==(const RunScenario&) const = default;
};

struct RunThreshold {
  std::string metric = "rms";
  double value = 0;
  std::optional<double> margin;  // share of the value that selection keeps free for what training has not seen
  bool operator==(const RunThreshold&) const = default;
};

// One metric over the validation of the variant that is shown.
struct RunMetric {
  std::string metric;
  double all_sessions = 0, worst_session = 0, worst_frame = 0;  // thresholds are held against the worst session
  bool operator==(const RunMetric&) const = default;
};

struct RunInterval {
  double lo = 0, hi = 0;
  bool operator==(const RunInterval&) const = default;
};

struct RunPayloadValue {
  std::string name, type, file;
  int line = 0, column = 0;
  bool operator==(const RunPayloadValue&) const = default;
};

enum class ChoiceKind { kVariant, kOriginal, kUndecided };

// kOriginal: measured, and no variant keeps the thresholds and is faster by the least gain; `reason` says why. kUndecided: not enough was
// measured to say so; `reason` says what is missing and how to go on. In both payload is empty and what belongs to a variant is unset.
struct RunChoice {
  ChoiceKind kind = ChoiceKind::kOriginal;
  std::string reason;        // one sentence, for all kinds
  std::string candidate_id;  // of RunCandidate; empty for the original
  std::vector<RunPayloadValue> payload;
  std::string strategy, pattern, filter, encoding;
  std::uint32_t block_pixels = 0;
  std::uint32_t period_frames = 1;
  std::optional<double> predicted_error, measured_error, worst_frame_error;
  std::optional<double> predicted_speedup, measured_speedup;
  std::optional<RunInterval> speedup_ci95;
  std::optional<double> wall_speedup;
  std::optional<RunInterval> wall_speedup_ci95;
  std::optional<double> predicted_frame_ms, measured_frame_ms, p95_ms, worst_ms;
  std::optional<double> pace;  // the original's time per fragment, validation over training; in predicted_frame_ms
  std::optional<double> hit_rate;  // of covered pixels, over the validation
  std::optional<double> cache_bytes_per_pixel;
  bool operator==(const RunChoice&) const = default;
};

struct RunOriginal {
  std::optional<double> frame_ms, wall_ms, with_prepass_ms;  // the last by the binding clock
  bool operator==(const RunOriginal&) const = default;
};

// The tail alone with a free payload: no variant of that payload can be faster.
struct RunLimit {
  std::optional<double> frame_ms;
  std::string candidate_id;  // whose tail it is
  bool operator==(const RunLimit&) const = default;
};

struct RunReason {
  std::string code;     // stable, dotted: "candidate.too_cheap"
  std::string message;  // one sentence
  bool operator==(const RunReason&) const = default;
};

struct RunParameter {
  std::string name;  // "alpha"
  double value = 0;
  std::optional<RunInterval> ci95;
  bool operator==(const RunParameter&) const = default;
};

struct RunErrorModel {
  std::string family;  // "exponential" (Eq. 4), "power", "logarithm", "constant"
  std::vector<RunParameter> parameters;
  std::optional<double> r_squared;
  std::string verdict;  // "good", or what is wrong with the fit
  bool operator==(const RunErrorModel&) const = default;
};

struct RunPoint {
  std::uint32_t period_frames = 1;
  std::optional<double> predicted_error, measured_error;
  std::optional<double> predicted_frame_ms, measured_frame_ms;
  std::optional<RunInterval> predicted_error_ci95;    // of the error model
  std::optional<RunInterval> measured_error_frames;   // what the errors of single frames lie in, but for 2.5% at each end
  std::optional<RunInterval> measured_frame_ms_ci95;  // of the median, by order statistics
  std::optional<double> predicted_hit_rate, measured_speedup;  // the latter of paired rounds in training
  std::optional<RunInterval> speedup_ci95;
  bool operator==(const RunPoint&) const = default;
};

// One way to cache a candidate: everything of a variant but the period, which the points go through.
struct RunConfiguration {
  std::string strategy, pattern, filter, encoding;
  std::uint32_t block_pixels = 0;
  std::optional<double> hit_ns, miss_ns;  // Eq. 5, per shaded fragment
  std::optional<double> overhead_ms;      // c of Eq. 5, per frame
  std::optional<double> cost_r_squared;
  std::string cost_verdict;
  std::vector<RunPoint> points;  // by ascending period, never last
  std::optional<double> cache_bytes_per_pixel;
  bool operator==(const RunConfiguration&) const = default;
};

// kPruned: dropped before training. kNotReached: the budget ended first. kFailed: crashed, hung or measured
// nothing usable. kRefused: cannot be cached safely.
enum class CandidateStatus { kTrained, kPruned, kNotReached, kFailed, kRefused };

struct RunCandidate {
  std::string id, name, type, file;
  int line = 0, column = 0;
  double cost = 0;                  // of the slice, in the analysis's units
  double cost_share = 0;            // of the whole shader's cost
  std::vector<std::string> inputs;  // "varying position", "uniform view.time", "texture albedo"
  CandidateStatus status = CandidateStatus::kPruned;
  RunReason reason;  // why it was not trained; empty if it was
  std::optional<RunErrorModel> error_model;
  std::optional<double> hit_rate_mu;  // of λ(n) = μ(1 − 1/n)
  std::vector<RunConfiguration> configurations;
  std::optional<double> limit_frame_ms;  // of its tail alone, in training
  bool operator==(const RunCandidate&) const = default;
};

// Names one point: a configuration of a candidate, at a period.
struct RunVariant {
  std::string candidate_id, strategy, pattern, filter, encoding;
  std::uint32_t block_pixels = 0;
  std::uint32_t period_frames = 1;
  bool operator==(const RunVariant&) const = default;
};

// A variant that selection took to validation, in the order tried.
struct RunAttempt {
  std::string candidate_id;
  std::string configuration;  // text: "two_pass, tiled 8x8, nearest, rgba8"
  std::uint32_t period_frames = 1;
  std::optional<double> measured_error, measured_speedup;
  std::optional<RunInterval> speedup_ci95;
  bool accepted = false;
  std::string reason;  // why not accepted (or why accepted)
  bool operator==(const RunAttempt&) const = default;
};

struct RunFrame {
  int frame = 0;
  double error = 0;                   // of the choice; NaN where nothing was covered or not measured
  std::optional<double> frame_ms;     // of the choice, median over the rounds that hit this frame
  std::optional<double> original_ms;  // of the original in the same rounds
  std::optional<double> hit_rate;
  bool operator==(const RunFrame&) const = default;
};

struct RunSession {
  std::string name;
  std::vector<RunFrame> frames;
  bool operator==(const RunSession&) const = default;
};

struct RunStage {
  std::string name;  // "compile", "train", ...; unique
  double seconds = 0;
  bool operator==(const RunStage&) const = default;
};

// PNG files beside result.json; empty where there is none (the original was chosen).
struct RunImages {
  std::string original, cached, error, hit_miss;
  std::string session;  // of which frame they are
  int frame = 0;
  double error_gain = 1;              // the error image shows |cached − original| times this
  std::string hit_color, miss_color;  // "#rrggbb" in the hit/miss image, for its legend; may be empty
  bool operator==(const RunImages&) const = default;
};

struct RunResult {
  std::string tool_version;
  std::string finished_at;  // UTC, ISO 8601; may be empty
  RunDevice device;
  std::string clock = "timestamps";  // the binding clock: "process_cpu" or "timestamps"
  RunShader shader;
  RunScenario scenario;
  std::string quality;                   // the level that binds; empty where none does
  std::vector<RunThreshold> thresholds;  // all that bind together
  double least_gain = 1;                 // a speed-up must exceed it
  RunThreshold threshold;                // the only one; of several {"share", 1}: the largest share of its threshold that any metric takes
  RunChoice choice;
  RunOriginal original;
  RunLimit limit;
  std::vector<RunCandidate> candidates;  // all, in the order of their rank
  std::vector<RunVariant> front;  // predicted Pareto front of error and time, by ascending error
  std::vector<RunAttempt> attempts;
  std::vector<RunSession> validation;
  std::vector<RunMetric> metrics;        // of the choice, or of the last attempt
  std::vector<std::string> warnings;
  std::vector<std::string> not_reached;  // what the budget left out, in words
  std::vector<std::string> strategies_refused;  // "repair: the shader takes derivatives ..."
  std::vector<RunStage> seconds;         // in the order run
  RunImages images;
  std::string command;  // that repeats this run
  bool operator==(const RunResult&) const = default;
};

// The whole result.json: two spaces of indent, keys in the order of the structs, a line feed at the end. Text
// that is not UTF-8 has its bad bytes replaced by U+FFFD.
std::string resultToJson(const RunResult& result);

// Errors (kInput): result.syntax (not JSON), result.version (of a later Reprise), result.invalid (a missing
// key or a value of the wrong type, named by its path: "choice.strategy"). Unknown keys are passed over.
Result<RunResult> resultFromJson(const std::string& text);

// Spellings of files and reports: "variant", "original", "undecided"; "trained", "pruned", "not_reached", "failed",
// "refused".
const char* nameOf(ChoiceKind kind);
const char* nameOf(CandidateStatus status);

}  // namespace reprise
