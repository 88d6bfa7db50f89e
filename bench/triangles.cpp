// bench/triangles: what drawing again costs, and what repairing instead, or leaving out objects without misses, gives, with meshes of 0.4k, 7k
// and 43k triangles.
//
// Scenes, at 1280x720: "marble" is shaders/marble/marble.toml, session "orbit", the segments of all meshes scaled, refreshed every 16 frames in
// blocks of 16 x 16 pixels; "spheres" is the best case for leaving out objects: 24 marble spheres side by side before a camera that stands
// still, of which one moves, never refreshed. Payload: the candidate that saves most among those that stick to the surface, kept as
// rgba16f, fetched bilinearly. All variants alternate with the original in one run; speed-ups are medians of paired ratios with a 95%
// interval. Objects: the share with misses in a frame, as variants see it that leave out the others.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <nlohmann/json.hpp>

#include "bench/probe_ranges.h"
#include "bench/timed_variants.h"
#include "cli/fit.h"
#include "cli/train.h"
#include "cli/version.h"
#include "fitting/solve/paired_ratio.h"
#include "profiler/scenario/read_scenario.h"
#include "profiler/scene/mesh.h"
#include "runtime/base/file.h"
#include "runtime/vulkan/context.h"

namespace reprise {
namespace {

constexpr const char* kSession = "orbit";
constexpr std::uint32_t kPeriod = 16;
constexpr double kMeshScales[] = {0.236, 1, 2.449};  // of segments in each direction
constexpr int kSpheresAcross = 6, kSpheresDown = 4;
constexpr const char* kStrategies[] = {"original", "original_prepass", "tail_only", "branch", "two_pass", "two_pass_objects", "three_pass", "repair"};

struct Bench {
  std::string worker_path, device, json_file;
  int rounds = 30;
  std::uint32_t width = 1280, height = 720;
  std::vector<int> octaves = {5, 20};
  std::vector<std::string> scenes = {"marble", "spheres"};
};

struct Run {
  std::string scene;
  int octaves = 5;
  double mesh_scale = 1;
  std::uint32_t period_frames() const { return scene == "spheres" ? kNeverRefresh : kPeriod; }
};

struct Row {
  std::string scene;
  std::uint32_t period_frames = kPeriod;
  std::size_t triangles = 0;
  int octaves = 0;
  std::string strategy;
  std::optional<double> objects_with_misses;  // share
  double frame_ms = 0;
  PairedRatio speedup;
};

void scaleMesh(double scale, MeshSpec& mesh) {
  const auto scaled = [&](int segments) { return std::max(3, static_cast<int>(std::lround(segments * scale))); };
  mesh.segments_u = scaled(mesh.segments_u);
  mesh.segments_v = scaled(mesh.segments_v);
}

void placeSpheres(Scenario& scenario) {
  scenario.objects.clear();
  for (int index = 0; index < kSpheresAcross * kSpheresDown; ++index) {
    Object sphere;
    sphere.name = fmt::format("sphere_{}", index);
    sphere.mesh.radius = 0.5f;
    sphere.mesh.segments_u = 18;
    sphere.mesh.segments_v = 9;
    const std::array<float, 3> centre = {1.25f * (static_cast<float>(index % kSpheresAcross) - 2.5f), 1.25f * (static_cast<float>(index / kSpheresAcross) - 1.5f), 0};
    sphere.motion.translate = FixedTrack{{centre[0], centre[1], centre[2]}};
    if (index == 0) sphere.motion.spin_rad_per_frame = 0.02f;
    scenario.objects.push_back(sphere);
  }
  for (SessionSpec& session : scenario.sessions) {
    session.motions.clear();
    session.camera.path = TrackPath{FixedTrack{{0, 0, 7.5f}}, FixedTrack{{0, 0, 0}}};
  }
}

// In 16 frames, at the scenario's resolution.
Result<double> objectsWithMisses(const Bench& bench, const Run& run, const Workspace& workspace, const std::string& original_dir, const std::string& dir) {
  Job job;
  job.kind = JobKind::kObjects;
  job.scenario_path = workspace.scenarioFile().string();
  job.session = kSession;
  job.original_dir = original_dir;
  job.device = bench.device;
  job.frames = 16;
  job.entries = {{dir, run.period_frames()}};
  SupervisorOptions options;
  options.worker_path = bench.worker_path;
  REPRISE_ASSIGN(const JobResult result, superviseJob(job, options, {}));
  return static_cast<double>(result.objects.at(0).flagged) / static_cast<double>(result.objects.at(0).drawn);
}

Result<std::vector<Row>> measure(const Bench& bench, const Run& run, const Workspace& workspace) {
  REPRISE_ASSIGN(Scenario scenario, readScenario(std::string(REPRISE_SOURCE_DIR) + "/shaders/marble/marble.toml"));
  scenario.defines = {{"OCTAVES", std::to_string(run.octaves)}};
  if (run.scene == "spheres") placeSpheres(scenario);
  scenario.width = bench.width;
  scenario.height = bench.height;
  std::size_t triangles = 0;
  for (Object& object : scenario.objects) {
    scaleMesh(run.mesh_scale, object.mesh);
    triangles += buildMesh(object.mesh).indices.size() / 3;
  }
  REPRISE_TRY(writeFile(workspace.scenarioFile(), writeScenario(scenario, workspace.scenarioFile().parent_path())));
  REPRISE_ASSIGN(const Subject subject, readSubject(workspace.scenarioFile()));
  const std::size_t candidate = surfacePayload(subject);
  REPRISE_ASSIGN(const ValueRanges ranges, probeRanges(subject, workspace, candidate, {kSession, bench.device, bench.worker_path}));
  std::vector<TimedVariant> timed;
  for (const char* strategy : kStrategies) {
    VariantOptions options = baseOptions(subject, ranges);
    options.strategy = strategy;
    options.period_frames = run.period_frames();
    REPRISE_ASSIGN(StoredVariant stored, storeVariant(workspace, subject.program, subject.candidates[candidate], options, subject.limits));
    timed.push_back({strategy, "", options, std::move(stored), {}});
  }
  REPRISE_TRY(timeVariants({bench.worker_path, bench.device, kSession, run.period_frames(), bench.rounds}, workspace, timed));
  std::vector<Row> rows;
  for (const TimedVariant& one : timed) {
    std::optional<double> share;
    if (flagsDraws(*findStrategy(one.strategy))) {
      REPRISE_ASSIGN(share, objectsWithMisses(bench, run, workspace, timed[0].stored.dir, one.stored.dir));
    }
    rows.push_back({run.scene, run.period_frames(), triangles, run.octaves, one.strategy, share, medianOf(one.clock_ms), pairedRatio(timed[0].clock_ms, one.clock_ms)});
  }
  return rows;
}

nlohmann::json toJson(const Row& row) {
  const auto period = row.period_frames == kNeverRefresh ? nlohmann::json() : nlohmann::json(row.period_frames);
  const auto objects = row.objects_with_misses ? nlohmann::json(*row.objects_with_misses) : nlohmann::json();
  return {{"scene", row.scene}, {"period_frames", period}, {"objects_with_misses", objects}, {"triangles", row.triangles}, {"octaves", row.octaves}, {"strategy", row.strategy}, {"frame_ms", row.frame_ms},
          {"speedup", row.speedup.ratio}, {"speedup_ci95", {row.speedup.lo, row.speedup.hi}}};
}

Result<void> run(const Bench& bench) {
  ContextOptions context_options;
  context_options.device = bench.device;
  REPRISE_ASSIGN(const Context context, Context::create(context_options));
  const DeviceSummary& device = context.summary();
  std::cout << fmt::format("{}; {}; clock: {}; {}x{}; marble: period {}, spheres: never refreshed; {} pairs; reprise {}\n\n", device.name, device.driver,
                           device.is_cpu ? "process CPU time" : "time stamps", bench.width, bench.height, kPeriod, bench.rounds, kToolVersion)
            << "| scene | octaves | triangles | strategy | objects with misses | frame ms | speed-up [95%] |\n|---|---|---|---|---|---|---|\n";
  const std::filesystem::path directory = std::filesystem::temp_directory_path() / fmt::format("reprise-triangles-{}", ::getpid());
  nlohmann::json rows = nlohmann::json::array();
  std::vector<Run> runs;
  for (const std::string& scene : bench.scenes)
    for (const int octaves : bench.octaves)
      for (const double scale : kMeshScales) runs.push_back({scene, octaves, scale});
  for (const Run& run : runs) {
    REPRISE_ASSIGN(const Workspace workspace, Workspace::open(directory));
    REPRISE_ASSIGN(const std::vector<Row> measured, measure(bench, run, workspace));
    for (const Row& row : measured) {
      const std::string share = row.objects_with_misses ? fmt::format("{:.0f}%", 100 * *row.objects_with_misses) : "";
      std::cout << fmt::format("| {} | {} | {} | {} | {} | {:.1f} | {:.2f} [{:.2f}, {:.2f}] |\n", row.scene, row.octaves, row.triangles, row.strategy, share,
                               row.frame_ms, row.speedup.ratio, row.speedup.lo, row.speedup.hi)
                << std::flush;
      rows.push_back(toJson(row));
    }
  }
  std::error_code status;
  std::filesystem::remove_all(directory, status);
  if (bench.json_file.empty()) return {};
  const nlohmann::json document = {{"device", device.name}, {"driver", device.driver}, {"clock", device.is_cpu ? "process_cpu" : "timestamps"},
                                   {"width", bench.width}, {"height", bench.height}, {"rows", rows}};
  return writeFile(bench.json_file, document.dump(2) + "\n");
}

}  // namespace
}  // namespace reprise

int main(int argc, char** argv) {
  reprise::Bench bench;
  CLI::App app("Times strategies at three mesh sizes in two scenes and prints one table");
  app.add_option("--json", bench.json_file, "write the rows to a file too");
  app.add_option("--device", bench.device, "index or part of the name");
  app.add_option("--octaves", bench.octaves, "only these")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--scenes", bench.scenes, "only these")->check(CLI::IsMember({"marble", "spheres"}))->capture_default_str();
  app.add_option("--rounds", bench.rounds, "pairs per variant")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--width", bench.width)->check(CLI::Range(1, 8192))->capture_default_str();
  app.add_option("--height", bench.height)->check(CLI::Range(1, 8192))->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  bench.worker_path = (std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / "reprise").string();
  const reprise::Result<void> result = reprise::run(bench);
  if (result.ok()) return 0;
  std::cerr << reprise::formatError(result.error()) << '\n';
  return 1;
}
