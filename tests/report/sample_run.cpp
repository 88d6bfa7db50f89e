#include "tests/report/sample_run.h"

#include <cmath>

namespace reprise::sample {
namespace {

constexpr double kCovered = 552960;  // pixels
constexpr double kOriginalNs = 170;  // per pixel
constexpr double kOverheadMs = 1.9;
constexpr double kBaselineMs = kCovered * kOriginalNs * 1e-6 + kOverheadMs;

struct Recipe {
  const char *name, *type;
  int line, column;
  double share, scale, exponent;  // error = scale * (n − 1)^exponent
  std::vector<std::string> inputs;
};

const std::vector<Recipe>& trainedRecipes() {
  static const std::vector<Recipe> recipes = {
      {"noise", "float", 58, 17, 0.87, 0.0031, 0.42, {"varying object_position"}},
      {"albedo",
       "vec3",
       71,
       10,
       0.90,
       0.0034,
       0.44,
       {"varying object_position", "uniform material.vein_color"}},
      {"diffuse",
       "vec3",
       80,
       18,
       0.93,
       0.0052,
       0.55,
       {"varying object_position", "varying normal", "uniform light.direction"}},
      {"shaded",
       "vec3",
       92,
       12,
       0.985,
       0.0125,
       0.74,
       {"varying object_position", "varying normal", "varying world_position",
        "uniform view.camera_position"}},
      {"octaves[0..11]", "float", 51, 9, 0.52, 0.0017, 0.36, {"varying object_position"}},
      {"octaves[12..19]", "float", 51, 9, 0.35, 0.0024, 0.48, {"varying object_position"}},
      {"turbulence", "float", 62, 15, 0.86, 0.0042, 0.42, {"varying object_position"}},
      {"specular",
       "float",
       86,
       20,
       0.055,
       0.021,
       0.61,
       {"varying normal", "varying world_position", "uniform view.camera_position"}},
      {"rotated", "vec3", 44, 14, 0.11, 0.0009, 0.31, {"varying object_position", "uniform material.turn"}},
  };
  return recipes;
}

// In [-1, 1], the same on every call.
double disturbance(std::uint32_t seed) {
  seed = (seed ^ 61u ^ (seed >> 16)) * 9u;
  seed = (seed ^ (seed >> 4)) * 0x27d4eb2du;
  return static_cast<double>((seed ^ (seed >> 15)) & 0xffffu) / 32767.5 - 1;
}

RunConfiguration configuration(const char* strategy, const char* pattern, std::uint32_t block,
                               const char* filter, const char* encoding) {
  RunConfiguration made;
  made.strategy = strategy, made.pattern = pattern, made.block_pixels = block;
  made.filter = filter, made.encoding = encoding;
  return made;
}

double strategyNs(const std::string& strategy) {
  return strategy == "two_pass"           ? 14
         : strategy == "two_pass_stencil" ? 21
         : strategy == "three_pass"       ? 27
                                          : 9;
}

void measure(RunConfiguration& made, const Recipe& recipe, std::uint32_t seed) {
  const bool branch = made.strategy == "branch";  // skips nothing on this device
  const double extra =
      strategyNs(made.strategy) + (made.filter == "bilinear" ? 5 : 0) + (made.encoding == "rgba8" ? 0 : 6);
  made.hit_ns = kOriginalNs * (branch ? 1 : 1 - recipe.share) + extra;
  made.miss_ns = kOriginalNs + extra + 11;
  made.overhead_ms = kOverheadMs;
  made.cost_r_squared = 0.991 - 0.01 * (disturbance(seed) + 1);
  made.cost_verdict = "good";
  const double error_factor =
      (made.filter == "nearest" ? 1.8 : 1.0) * (made.encoding == "rgba8" ? 1.03 : 1.0);
  for (const std::uint32_t period : {1u, 2u, 4u, 8u, 16u, 32u, 64u, 0u}) {
    RunPoint point;
    point.period_frames = period;
    const double age = period == 0 ? 95 : period - 1;
    const double hit_rate = 0.94 * (period == 0 ? 1 : 1 - 1.0 / period);
    const double modelled = age == 0 ? 0 : error_factor * recipe.scale * std::pow(age, recipe.exponent);
    if (period != 0) {
      point.predicted_error = modelled;
      point.predicted_frame_ms =
          *made.overhead_ms + kCovered * 1e-6 * (hit_rate * *made.hit_ns + (1 - hit_rate) * *made.miss_ns);
    }
    point.measured_error = modelled * (1 + 0.06 * disturbance(seed * 31 + period));
    if (period == 4 || period == 32 || period == 0) {
      const double exact =
          *made.overhead_ms + kCovered * 1e-6 * (hit_rate * *made.hit_ns + (1 - hit_rate) * *made.miss_ns);
      point.measured_frame_ms = exact * (1 + 0.025 * disturbance(seed * 77 + period));
    }
    made.points.push_back(point);
  }
}

RunCandidate trained(const Recipe& recipe, std::uint32_t seed) {
  RunCandidate made;
  made.id = "c" + std::to_string(seed);
  made.name = recipe.name, made.type = recipe.type, made.file = "shaders/marble/marble20.frag";
  made.line = recipe.line, made.column = recipe.column;
  made.cost = std::round(6120 * recipe.share), made.cost_share = recipe.share;
  made.inputs = recipe.inputs;
  made.status = CandidateStatus::kTrained;
  made.hit_rate_mu = 0.94;
  made.error_model =
      RunErrorModel{"power",
                    {{"a", recipe.scale, RunInterval{recipe.scale * 0.95, recipe.scale * 1.06}},
                     {"p", recipe.exponent, RunInterval{recipe.exponent - 0.02, recipe.exponent + 0.02}}},
                    0.993 - 0.004 * seed,
                    "good"};
  made.configurations = {configuration("two_pass", "tiled", 16, "bilinear", "rgba8"),
                         configuration("two_pass", "random", 8, "bilinear", "rgba16f"),
                         configuration("two_pass", "tiled", 16, "nearest", "rgba8"),
                         configuration("two_pass_stencil", "tiled", 16, "bilinear", "rgba8"),
                         configuration("three_pass", "interleaved", 8, "bilinear", "rgba32f")};
  if (seed < 4) made.configurations.push_back(configuration("branch", "tiled", 16, "bilinear", "rgba8"));
  for (std::size_t i = 0; i < made.configurations.size(); ++i) {
    measure(made.configurations[i], recipe, seed * 16 + static_cast<std::uint32_t>(i));
  }
  return made;
}

RunCandidate dropped(const char* id, const char* name, double share, CandidateStatus status,
                     RunReason reason) {
  RunCandidate made;
  made.id = id, made.name = name, made.type = "vec3", made.file = "shaders/marble/marble20.frag";
  made.line = 33, made.column = 8;
  made.cost = std::round(6120 * share), made.cost_share = share;
  made.inputs = {"varying normal"};
  made.status = status;
  made.reason = std::move(reason);
  return made;
}

void addDropped(RunResult& run) {
  using Status = CandidateStatus;
  run.candidates.push_back(
      dropped("c20", "n", 0.004, Status::kPruned,
              {"candidate.too_cheap", "costs less than a lookup (24 of 6120; a lookup costs about 90)"}));
  run.candidates.push_back(
      dropped("c21", "half_vector", 0.006, Status::kPruned,
              {"candidate.too_cheap", "costs less than a lookup (37 of 6120; a lookup costs about 90)"}));
  run.candidates.push_back(dropped("c22", "noise * 0.5 + 0.5", 0.87, Status::kPruned,
                                   {"candidate.near_duplicate", "differs from noise by two instructions"}));
  run.candidates.push_back(
      dropped("c23", "vein", 0.86, Status::kPruned,
              {"candidate.dominated", "costs less than albedo and depends on the same inputs"}));
  run.candidates.push_back(dropped("c24", "gradient", 0.88, Status::kRefused,
                                   {"candidate.tail_derivatives",
                                    "the tail takes derivatives of values that depend on it; helper lanes "
                                    "would hold other surfaces' payloads"}));
  run.candidates.push_back(
      dropped("c25", "bumped", 0.41, Status::kFailed,
              {"worker.crashed", "the worker died with signal 11 in frame 3 of session orbit_slow"}));
  run.candidates.push_back(dropped("c26", "octaves[4..19]", 0.71, Status::kNotReached,
                                   {"budget.exhausted", "the budget of 480 s ended before its turn"}));
}

void addValidation(RunResult& run) {
  for (const char* name : {"orbit_fast", "walk"}) {
    RunSession session;
    session.name = name;
    for (int frame = 0; frame < 96; ++frame) {
      const auto seed = static_cast<std::uint32_t>(frame) + (name[0] == 'w' ? 1000u : 0u);
      RunFrame row;
      row.frame = frame;
      const double wave = 1 + 0.28 * std::sin(frame * 0.13 + name[0]);
      row.error =
          frame == 0 ? 0 : 0.0131 * wave * (1 - std::exp(-frame / 6.0)) * (1 + 0.05 * disturbance(seed));
      row.original_ms =
          kBaselineMs * (1 + 0.12 * std::sin(frame * 0.065)) * (1 + 0.02 * disturbance(seed + 5000));
      row.hit_rate = frame == 0 ? 0 : 0.885 + 0.03 * disturbance(seed + 9000);
      row.frame_ms = *row.original_ms * (frame == 0 ? 1.16 : 0.32) * (1 + 0.03 * disturbance(seed + 7000));
      session.frames.push_back(row);
    }
    run.validation.push_back(session);
  }
}

RunResult common() {
  RunResult run;
  run.tool_version = "0.1.0";
  run.finished_at = "2024-05-14T09:31:07Z";
  run.device = {"llvmpipe (LLVM 15.0.6, 256 bits)", "Mesa 22.3.6", true, "AMD EPYC 7B13, 2 cores"};
  run.clock = "process_cpu";
  run.shader = {"shaders/marble/marble20.frag", "shaders/marble/marble.vert",
                "6d0c1f0a5be3c1f19a77c2a6f1f0f3aa"};
  run.scenario = {"shaders/marble/marble20.toml",
                  "marble, 20 octaves",
                  "f30b2cc4d0aa41e7a94a8a34a5e29f10",
                  1280,
                  720,
                  7,
                  288};
  run.thresholds = {{"rms", 0.02}};
  run.least_gain = 1.05;
  run.threshold = {"rms", 0.02};
  run.original = {kBaselineMs, 61.2, kBaselineMs + 8.3};
  run.command = "reprise optimize shaders/marble/marble20.toml --max-error 0.02 --metric rms -o out/marble20";
  run.seconds = {{"compile", 0.21},       {"analyse", 0.04},      {"enumerate", 0.02}, {"rewrite", 3.1},
                 {"train errors", 141.7}, {"train times", 186.4}, {"fit", 0.6},        {"select", 0.01},
                 {"validate", 62.5},      {"report", 0.4}};
  std::uint32_t seed = 1;
  for (const Recipe& recipe : trainedRecipes()) run.candidates.push_back(trained(recipe, seed++));
  addDropped(run);
  addValidation(run);
  run.strategies_refused = {"two_pass_stencil: the application's state has no stencil"};
  run.not_reached = {"1 of 10 candidates worth training (octaves[4..19])", "periods 32 and 64 of three_pass"};
  run.limit = {21.4, "c2"};
  run.metrics = {{"rms", 0.0143, 0.0151, 0.0212}, {"over8", 0.061, 0.078, 0.12}, {"tile_flip", 0.081, 0.094, 0.11}};
  run.attempts = {{"c2", "two_pass, tiled 16×16, bilinear, rgba8", 64, 0.0226, 3.29, RunInterval{3.2, 3.38},
                   false, "error 0.0226 is above the threshold 0.02"},
                  {"c2", "two_pass, tiled 16×16, bilinear, rgba8", 32, 0.0151, 3.12, RunInterval{3.04, 3.21},
                   true, "keeps the threshold and is faster beyond the noise"}};
  return run;
}

}  // namespace

RunResult variantRun() {
  RunResult run = common();
  RunChoice& choice = run.choice;
  choice.kind = ChoiceKind::kVariant;
  choice.reason =
      "It was the fastest prediction that kept the threshold when validated; one variant predicted to be "
      "faster did not.";
  choice.candidate_id = "c2";
  choice.payload = {{"albedo", "vec3", "shaders/marble/marble20.frag", 71, 10}};
  choice.strategy = "two_pass", choice.pattern = "tiled", choice.block_pixels = 16;
  choice.filter = "bilinear", choice.encoding = "rgba8", choice.period_frames = 32;
  choice.predicted_error = 0.0159, choice.measured_error = 0.0151, choice.worst_frame_error = 0.0178;
  choice.predicted_speedup = 3.22, choice.measured_speedup = 3.12,
  choice.speedup_ci95 = RunInterval{3.04, 3.21};
  choice.wall_speedup = 2.93, choice.wall_speedup_ci95 = RunInterval{2.7, 3.18};
  choice.predicted_frame_ms = 29.8, choice.measured_frame_ms = 30.7, choice.pace = 1.04, choice.p95_ms = 33.9,
  choice.worst_ms = 109.3;
  choice.hit_rate = 0.885, choice.cache_bytes_per_pixel = 8;
  run.images = {"images/original.png",
                "images/cached.png",
                "images/error.png",
                "images/hit_miss.png",
                "orbit_fast",
                48,
                8,
                "#2f6f4f",
                "#d08b2c"};
  run.warnings = {
      "The machine was busy while times were measured (load 1.4 on 2 cores); intervals are wider than "
      "usual."};
  return run;
}

RunResult originalRun() {
  RunResult run = common();
  run.threshold.value = 0.0008;
  run.choice.reason =
      "no variant keeps an error of 0.0008 rms and is faster beyond the noise; the closest, rotated at "
      "period 2, was 0.96 times as fast";
  run.limit = {};
  run.attempts = {{"c9", "two_pass, tiled 16×16, bilinear, rgba8", 2, 0.00071, 0.96, RunInterval{0.94, 0.98},
                   false, "not faster than the original beyond the noise"}};
  run.scenario.name = "marble, 20 octaves, strict";
  return run;
}

RunResult emptyRun() {
  RunResult run;
  run.tool_version = "0.1.0";
  run.scenario.name = "empty";
  run.threshold.value = 0.02;
  run.choice.reason = "the shader has no value that is worth keeping";
  return run;
}

RunResult hostileRun() {
  RunResult run = variantRun();
  const std::string bad =
      "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'&<!-- @SCRIPT@ @DATA@ "
      "\x1b[31m\xff\x80";
  run.scenario.name = run.scenario.path = run.shader.fragment = run.device.name = run.command = bad;
  run.warnings.push_back(bad);
  run.not_reached.push_back(bad);
  run.strategies_refused.push_back(bad);
  run.choice.reason = bad;
  for (RunPayloadValue& value : run.choice.payload) value.name = value.file = value.type = bad;
  for (RunCandidate& candidate : run.candidates) {
    candidate.name = candidate.file = candidate.type = bad;
    candidate.reason.message = candidate.reason.code = bad;
    for (std::string& input : candidate.inputs) input = bad;
    for (RunConfiguration& made : candidate.configurations) made.cost_verdict = bad;
    if (candidate.error_model) candidate.error_model->family = candidate.error_model->verdict = bad;
  }
  for (RunAttempt& attempt : run.attempts) attempt.configuration = attempt.reason = bad;
  for (RunSession& session : run.validation) session.name = bad;
  run.images.session = run.images.hit_color = bad;
  run.seconds.push_back({bad, 1});
  return run;
}

}  // namespace reprise::sample
