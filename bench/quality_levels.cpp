// What the metrics of the quality levels give where differences are capped at T of 255, T = 4, 8 and 16 (profiler/metrics/quality.h).
//
// In each shipped scene, the candidate of the best four whose errors at period 8 are largest is played at that period in the first
// training session. Its differences to the original are cut at T per channel. A scene says nothing about T, and is left out there, where
// even a tile of the 99th percentile has fewer than an eighth of its pixels at T. The last lines are the medians over the scenes: the thresholds of the levels.
//
//   build/release/bench/quality_levels [--frames 28] [--device NAME]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <map>

#include "bench/probe_ranges.h"
#include "bench/published_cases.h"
#include "cli/subject.h"
#include "cli/train.h"
#include "cli/trained.h"
#include "cli/workspace.h"
#include "compiler/strategies/refuse_variant.h"
#include "profiler/metrics/metrics.h"

namespace reprise {
namespace {

constexpr std::uint32_t kPeriod = 8;
constexpr std::size_t kCandidates = 4;
constexpr double kLeastAtCap = 0.125;
constexpr int kCaps[] = {4, 8, 16};
const std::vector<std::string> kMetrics = {"tile_flip", "tile_rms", "tile_flicker", "blocks", "rms", "over8"};

struct Arguments {
  int frames = 28;
  std::string device, worker_path = (std::filesystem::path(REPRISE_SOURCE_DIR) / "build/release/reprise").string();
};

using Values = std::map<std::string, double>;

class Scene {
 public:
  Scene(const Arguments& arguments, const Subject& subject, const Workspace& workspace) : arguments_(arguments), subject_(subject), workspace_(workspace) {
    for (const SessionSpec& session : subject.scenario.sessions)
      if (session_.empty() && session.role == SessionRole::kTraining) session_ = session.name;
  }

  // The largest errors of the best candidates.
  Result<StoredVariant> mostDifferent() {
    std::vector<StoredVariant> variants;
    for (std::size_t i = 0; i < std::min(kCandidates, subject_.candidates.size()); ++i) {
      if (!subject_.candidates[i].kept()) continue;
      const Result<ValueRanges> ranges = probeRanges(subject_, workspace_, i, {session_, arguments_.device, arguments_.worker_path});
      if (!ranges.ok()) continue;
      VariantOptions options = baseOptions(subject_, *ranges, subject_.candidates[i]);
      options.strategy = "two_pass";  // cheapest on CPU devices
      if (refuseVariant(subject_.program, subject_.candidates[i], options, subject_.limits)) options.strategy = "branch";
      options.instrumented = options.aged = true;
      const Result<StoredVariant> variant = storeVariant(workspace_, subject_.program, subject_.candidates[i], options, subject_.limits);
      if (variant.ok()) variants.push_back(*variant);
    }
    if (variants.empty()) return Error{ErrorKind::kMeasurement, "levels.candidates", "no candidate can be played", {}};
    std::vector<JobEntry> entries;
    for (const StoredVariant& variant : variants) entries.push_back({variant.dir, kPeriod});
    REPRISE_ASSIGN(const std::vector<Values> values, valuesOf(entries, {"rms"}));
    std::size_t largest = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
      if (values[i].at("rms") > values[largest].at("rms")) largest = i;
    return variants[largest];
  }

  // By entry: the session's value of each metric.
  Result<std::vector<Values>> valuesOf(const std::vector<JobEntry>& entries, const std::vector<std::string>& metrics) {
    const bool stereo = subject_.scenario.stereo.has_value();
    VariantOptions original = baseOptions(subject_, {});
    original.strategy = "original";
    REPRISE_ASSIGN(const StoredVariant reference, storeVariant(workspace_, subject_.program, subject_.candidates[0], original, subject_.limits));
    Job job;
    job.scenario_path = workspace_.scenarioFile().string();
    job.session = session_;
    job.original_dir = reference.dir;
    job.entries = entries;
    job.metrics = metrics;
    job.frames = arguments_.frames;
    job.device = arguments_.device;
    SupervisorOptions options;
    options.worker_path = arguments_.worker_path;
    options.silence_timeout_s = 300;
    REPRISE_ASSIGN(const JobResult result, superviseJob(job, options, {}));
    std::vector<Values> values;
    for (const std::vector<ErrorRow>& rows : result.errors) {
      values.emplace_back();
      for (const std::string& metric : metrics)
        values.back()[metric] = sessionError(metric, {&rows}, kPeriod, stereo ? PatternKind::kWhole : PatternKind::kInterleaved).value_or(std::nan(""));
    }
    return values;
  }

 private:
  const Arguments& arguments_;
  const Subject& subject_;
  const Workspace& workspace_;
  std::string session_;
};

// By T: what the scene says.
Result<std::map<int, Values>> measureScene(const PublishedCase& one, const Arguments& arguments) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("reprise-levels-" + one.name);
  REPRISE_ASSIGN(const Subject subject, readSubject((std::filesystem::path(REPRISE_SOURCE_DIR) / "shaders" / one.scenario).string()));
  REPRISE_ASSIGN(const Workspace workspace, Workspace::open(folder.string()));
  REPRISE_TRY(copyInputs(subject, workspace.scenarioFile()));
  Scene scene(arguments, subject, workspace);
  REPRISE_ASSIGN(const StoredVariant variant, scene.mostDifferent());
  std::vector<JobEntry> entries;
  for (const int cap : kCaps) entries.push_back({variant.dir, kPeriod, 0, cap / 255.0});
  REPRISE_ASSIGN(const std::vector<Values> values, scene.valuesOf(entries, kMetrics));
  std::map<int, Values> by_cap;
  for (std::size_t i = 0; i < entries.size(); ++i) by_cap[kCaps[i]] = values[i];
  std::filesystem::remove_all(folder);
  return by_cap;
}

std::string rowText(const std::string& name, int cap, const Values& values) {
  std::string text = fmt::format("{:<12} {:>3}", name, cap);
  for (const std::string& metric : kMetrics) text += fmt::format("  {:>12.4f}", values.at(metric));
  return text;
}

int measureAll(const Arguments& arguments) {
  std::cout << fmt::format("{:<12} {:>3}", "scene", "T");
  for (const std::string& metric : kMetrics) std::cout << fmt::format("  {:>12}", metric);
  std::cout << std::endl;
  std::map<int, std::map<std::string, std::vector<double>>> all;
  for (const PublishedCase& one : publishedCases()) {
    const Result<std::map<int, Values>> scene = measureScene(one, arguments);
    if (!scene.ok()) {
      std::cout << one.name << ": " << scene.error().message << std::endl;
      continue;
    }
    for (const auto& [cap, values] : *scene) {
      // Differences that are all at T have an rms of T; an eighth of them that of sqrt(1/8) T.
      const bool counts = values.at("tile_rms") >= std::sqrt(kLeastAtCap) * cap / 255.0;
      std::cout << rowText(one.name, cap, values) << (counts ? "" : "  left out: too few pixels reach T") << std::endl;
      if (!counts) continue;
      for (const auto& [metric, value] : values)
        if (std::isfinite(value)) all[cap][metric].push_back(value);
    }
  }
  for (const auto& [cap, metrics] : all) {
    Values medians;
    for (const std::string& metric : kMetrics) medians[metric] = metrics.count(metric) > 0 ? medianOf(metrics.at(metric)) : std::nan("");
    std::cout << rowText("median", cap, medians) << std::endl;
  }
  return 0;
}

}  // namespace
}  // namespace reprise

int main(int argc, char** argv) {
  CLI::App app{"what metrics give where differences are capped at T of 255"};
  reprise::Arguments arguments;
  app.add_option("--frames", arguments.frames)->capture_default_str();
  app.add_option("--device", arguments.device);
  app.add_option("--reprise", arguments.worker_path);
  CLI11_PARSE(app, argc, argv);
  return reprise::measureAll(arguments);
}
