// bench/marble: what each strategy gives on the marble, in one table from one run.
//
// Scene: shaders/marble/marble.toml, session "orbit" (0.02 radians a frame), payload: the candidate that saves most among those
// that depend on the object alone. Refresh period 16, interleaved blocks of 16 x 16 pixels (6% due per frame). For every strategy the
// filters and encodings below are timed, alternating with the original in the same run, and the fastest is shown.
// two_pass_stencil needs a stencil buffer: it and its own original are timed with D32_SFLOAT_S8_UINT.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "bench/probe_ranges.h"
#include "bench/timed_variants.h"
#include "cli/fit.h"
#include "cli/subject.h"
#include "cli/train.h"
#include "cli/version.h"
#include "cli/workspace.h"
#include "fitting/solve/paired_ratio.h"
#include "profiler/scenario/read_scenario.h"
#include "profiler/session/job.h"
#include "runtime/base/file.h"
#include "runtime/vulkan/context.h"

namespace reprise {
namespace {

constexpr const char* kSession = "orbit";
constexpr std::uint32_t kPeriod = 16;
constexpr std::uint32_t kBlock = 16;
constexpr int kErrorFrames = 48;
constexpr std::uint32_t kSizes[][2] = {{640, 360}, {1280, 720}};
constexpr Filter kFilters[] = {Filter::kBilinear, Filter::kNearest};
constexpr Encoding kEncodings[] = {Encoding::kRgba16, Encoding::kRgba16f, Encoding::kRgba8};

struct Row {
  std::string name, variant;
  double frame_ms = 0;
  PairedRatio speedup;
  double error = std::nan("");
};

struct Bench {
  std::string worker_path, device;
  bool cpu_clock = true;
  int rounds = 20;
  std::vector<int> octaves = {5, 10, 20, 27};
  std::vector<int> widths = {640, 1280};
  bool all = false;
};

// The marble with other octaves, size and depth format, written beside the variants.
Result<Subject> marbleWith(int octaves, const std::uint32_t (&size)[2], bool stencil, const Workspace& workspace) {
  REPRISE_ASSIGN(Scenario scenario, readScenario(std::string(REPRISE_SOURCE_DIR) + "/shaders/marble/marble.toml"));
  scenario.defines = {{"OCTAVES", std::to_string(octaves)}};
  scenario.width = size[0];
  scenario.height = size[1];
  scenario.state.depth_stencil = stencil;
  REPRISE_TRY(writeFile(workspace.scenarioFile(), writeScenario(scenario, workspace.scenarioFile().parent_path())));
  return readSubject(workspace.scenarioFile());
}

Result<std::vector<TimedVariant>> variantsOf(const Subject& subject, const Workspace& workspace, std::size_t candidate, const ValueRanges& ranges, bool stencil) {
  std::vector<TimedVariant> timed;
  const auto add = [&](const std::string& strategy, const VariantOptions& base) -> Result<void> {
    VariantOptions options = base;
    options.strategy = strategy;
    const Result<StoredVariant> stored = storeVariant(workspace, subject.program, subject.candidates[candidate], options, subject.limits);
    if (!stored.ok()) return stored.error();
    timed.push_back({strategy, fmt::format("{}, {}", nameOf(options.filter), nameOf(options.encoding)), options, *stored, {}});
    return {};
  };
  VariantOptions base = baseOptions(subject, ranges);
  base.block_pixels = kBlock;
  base.period_frames = kPeriod;
  REPRISE_TRY(add("original", base));
  REPRISE_TRY(add("original_prepass", base));
  REPRISE_TRY(add("tail_only", base));
  for (const Strategy& strategy : strategies()) {
    if (!strategy.selectable || strategy.needs_stencil != stencil) continue;
    for (const Filter filter : kFilters)
      for (const Encoding encoding : kEncodings) {
        VariantOptions options = base;
        options.filter = filter;
        options.encoding = encoding;
        REPRISE_TRY(add(strategy.name, options));
      }
  }
  return timed;
}

Result<double> errorOf(const Bench& bench, const Subject& subject, const Workspace& workspace, std::size_t candidate, const TimedVariant& variant) {
  VariantOptions options = variant.options;
  options.instrumented = true;
  REPRISE_ASSIGN(const StoredVariant stored, storeVariant(workspace, subject.program, subject.candidates[candidate], options, subject.limits));
  Job job;
  job.kind = JobKind::kErrors;
  job.scenario_path = workspace.scenarioFile().string();
  job.session = kSession;
  job.original_dir = variant.stored.dir;
  job.entries = {{stored.dir, kPeriod}};
  job.frames = kErrorFrames;
  job.device = bench.device;
  REPRISE_ASSIGN(const JobResult result, superviseJob(job, {bench.worker_path, 60, {}}, {}));
  return sessionError("rms", {&result.errors[0]}, kPeriod).value_or(std::nan(""));
}

// One size and octave count: the rows of the table. The stencil strategy adds its own original.
Result<std::vector<Row>> measure(const Bench& bench, int octaves, const std::uint32_t (&size)[2], bool stencil, const Workspace& workspace) {
  REPRISE_ASSIGN(const Subject subject, marbleWith(octaves, size, stencil, workspace));
  const std::size_t candidate = surfacePayload(subject);
  REPRISE_ASSIGN(const ValueRanges ranges, probeRanges(subject, workspace, candidate, {kSession, bench.device, bench.worker_path}));
  REPRISE_ASSIGN(std::vector<TimedVariant> timed, variantsOf(subject, workspace, candidate, ranges, stencil));
  REPRISE_TRY(timeVariants({bench.worker_path, bench.device, kSession, kPeriod, bench.rounds}, workspace, timed));
  const std::size_t reference = medianOf(timed[1].clock_ms) < medianOf(timed[0].clock_ms) ? 1 : 0;
  std::vector<Row> rows;
  const auto rowOf = [&](const TimedVariant& one) {
    return Row{one.strategy, one.variant, medianOf(one.clock_ms), pairedRatio(timed[reference].clock_ms, one.clock_ms), std::nan("")};
  };
  for (std::size_t i = 0; i < 3; ++i) rows.push_back(rowOf(timed[i]));
  for (Row& row : rows) row.variant = stencil ? "with stencil" : "";
  for (const Strategy& strategy : strategies()) {
    const TimedVariant* best = nullptr;
    for (const TimedVariant& one : timed) {
      if (one.strategy != strategy.name || !strategy.selectable) continue;
      if (bench.all) rows.push_back(rowOf(one));
      if (best == nullptr || medianOf(one.clock_ms) < medianOf(best->clock_ms)) best = &one;
    }
    if (best == nullptr || bench.all) continue;
    Row row = rowOf(*best);
    REPRISE_ASSIGN(row.error, errorOf(bench, subject, workspace, candidate, *best));
    rows.push_back(row);
  }
  return rows;
}

void print(const Row& row, int octaves, const std::uint32_t (&size)[2], double limit_ms) {
  std::cout << fmt::format("| {} | {}x{} | {} | {} | {:.1f} | {:.2f} [{:.2f}, {:.2f}] | {} | {} |\n", octaves, size[0], size[1], row.name, row.variant,
                           row.frame_ms, row.speedup.ratio, row.speedup.lo, row.speedup.hi,
                           row.frame_ms > 0 ? fmt::format("{:.0f}%", 100 * limit_ms / row.frame_ms) : "", std::isfinite(row.error) ? fmt::format("{:.4f}", row.error) : "")
            << std::flush;
}

nlohmann::json toJson(const Row& row, int octaves, const std::uint32_t (&size)[2], double limit_ms) {
  return {{"octaves", octaves}, {"width", size[0]}, {"height", size[1]}, {"strategy", row.name}, {"variant", row.variant}, {"frame_ms", row.frame_ms},
          {"speedup", row.speedup.ratio}, {"speedup_ci95", {row.speedup.lo, row.speedup.hi}}, {"share_of_limit", limit_ms / row.frame_ms},
          {"error_rms", std::isfinite(row.error) ? nlohmann::json(row.error) : nlohmann::json(nullptr)}};
}

Result<void> run(Bench bench, const std::string& json_file) {
  ContextOptions context_options;
  context_options.device = bench.device;
  REPRISE_ASSIGN(const Context context, Context::create(context_options));
  bench.cpu_clock = context.summary().is_cpu;
  std::cout << fmt::format("Marble, {}; {}; clock: {}; period {}, blocks {}x{}; {} pairs; reprise {}\n\n", context.summary().name, context.summary().driver,
                           bench.cpu_clock ? "process CPU time" : "time stamps", kPeriod, kBlock, kBlock, bench.rounds, kToolVersion);
  std::cout << "| octaves | size | strategy | variant | frame ms | speed-up [95%] | share of limit | RMS error |\n|---|---|---|---|---|---|---|---|\n";
  const std::filesystem::path directory = std::filesystem::temp_directory_path() / fmt::format("reprise-bench-{}", ::getpid());
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& size : kSizes) {
    if (std::find(bench.widths.begin(), bench.widths.end(), static_cast<int>(size[0])) == bench.widths.end()) continue;
    for (const int octaves : bench.octaves)
      for (const bool stencil : {false, true}) {
        REPRISE_ASSIGN(const Workspace workspace, Workspace::open(directory));
        REPRISE_ASSIGN(const std::vector<Row> measured, measure(bench, octaves, size, stencil, workspace));
        for (const Row& row : measured) {
          print(row, octaves, size, measured[2].frame_ms);
          rows.push_back(toJson(row, octaves, size, measured[2].frame_ms));
        }
      }
  }
  std::error_code status;
  std::filesystem::remove_all(directory, status);
  if (json_file.empty()) return {};
  const nlohmann::json document = {{"device", context.summary().name}, {"driver", context.summary().driver},
                                   {"clock", bench.cpu_clock ? "process_cpu" : "timestamps"}, {"period_frames", kPeriod}, {"rows", rows}};
  return writeFile(json_file, document.dump(2) + "\n");
}

}  // namespace
}  // namespace reprise

int main(int argc, char** argv) {
  reprise::Bench bench;
  std::string json_file;
  CLI::App app("Times every strategy on the marble and prints one table");
  app.add_option("--json", json_file, "write the rows to a file too");
  app.add_option("--device", bench.device, "index or part of the name");
  app.add_option("--octaves", bench.octaves, "only these")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--widths", bench.widths, "only these: 640 (x360), 1280 (x720)")->check(CLI::IsMember({640, 1280}))->capture_default_str();
  app.add_flag("--all", bench.all, "every filter and encoding, without errors, instead of the fastest");
  app.add_option("--rounds", bench.rounds, "pairs per variant")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  bench.worker_path = (std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / "reprise").string();
  const reprise::Result<void> result = reprise::run(bench, json_file);
  if (result.ok()) return 0;
  std::cerr << reprise::formatError(result.error()) << '\n';
  return 1;
}
