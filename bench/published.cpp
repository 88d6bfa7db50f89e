// bench/published: the cases that the literature has numbers for, each taken through `optimize` at a threshold of 0.02 RMS, and one table.
//
// Speed-ups are those that validation measured: medians of paired ratios with a 95% interval, by the binding clock, against the
// faster of the original and the original behind a depth prepass. Limit: that one's time over that of the tail alone with a free payload;
// share: how much of that limit the variant reaches. Prediction: predicted over measured, less 1.
// What a run measured stays in --output, so that a run that was cut short goes on where it stopped.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "bench/published_cases.h"
#include "bench/regret.h"
#include "cli/pipeline.h"
#include "cli/trained.h"
#include "cli/version.h"
#include "profiler/scenario/read_scenario.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

struct Bench {
  std::string device, worker_path, output = "published", json_file;
  std::vector<std::string> cases;
  std::string quality;  // in place of max_error
  double max_error = 0.02, budget_s = 300;
  std::uint32_t width = 1280, height = 720;
  bool regret = false;
};

struct Line {
  PublishedCase published;
  RunResult run;
  std::optional<std::size_t> named_rank;
};

std::optional<double> ratioOf(std::optional<double> above, std::optional<double> below) {
  if (!above || !below || !(*below > 0)) return std::nullopt;
  return *above / *below;
}

double secondsOf(const RunResult& run) {
  double sum = 0;
  for (const RunStage& stage : run.seconds) sum += stage.seconds;
  return sum;
}

std::string payloadOf(const RunChoice& choice) {
  std::string text;
  for (const RunPayloadValue& value : choice.payload) text += (text.empty() ? "" : " + ") + (value.name.empty() ? "a value of line " + std::to_string(value.line) : value.name);
  return text;
}

std::string orDash(const std::optional<double>& value, const char* format) {
  return value && std::isfinite(*value) ? fmt::format(fmt::runtime(format), *value) : "-";
}

std::string percentOrDash(const std::optional<double>& share) {
  return share && std::isfinite(*share) ? fmt::format("{:.0f}%", 100 * *share) : "-";
}

// What speed-ups are against.
std::optional<double> referenceMs(const RunResult& run) {
  if (!run.original.frame_ms || !run.original.with_prepass_ms) return run.original.frame_ms;
  return std::min(*run.original.frame_ms, *run.original.with_prepass_ms);
}

std::optional<double> limitSpeedup(const RunResult& run) { return ratioOf(referenceMs(run), run.limit.frame_ms); }

std::optional<double> missedBy(std::optional<double> predicted, std::optional<double> measured) {
  const auto ratio = ratioOf(predicted, measured);
  return ratio ? std::optional<double>(*ratio - 1) : std::nullopt;
}

std::string rowText(const Line& line) {
  const RunChoice& choice = line.run.choice;
  const std::string named = line.named_rank ? fmt::format("{} ({})", *line.named_rank, line.published.named_payload) : "-";
  if (choice.kind == ChoiceKind::kOriginal)
    return fmt::format("| {} | original: {} | | | 1 | - | - | - | {} | {} | {} | {:.0f} |", line.published.name, choice.reason,
                       line.published.published, line.published.asked ? fmt::format("{}", *line.published.asked) : "-", named, secondsOf(line.run));
  const std::string period = choice.period_frames == 0 ? "never" : std::to_string(choice.period_frames);
  const auto limit = limitSpeedup(line.run);
  const std::string pattern = choice.block_pixels == 0 ? choice.pattern : fmt::format("{} {}", choice.pattern, choice.block_pixels);
  return fmt::format("| {} | {} | {}, {}, {}, {} | {} | {} [{}, {}] | {} | {} | {} ({}) | {} | {} | {} | {:.0f} |", line.published.name, payloadOf(choice),
                     choice.strategy, pattern, choice.filter, choice.encoding, period, orDash(choice.measured_speedup, "{:.2f}"),
                     orDash(choice.speedup_ci95 ? std::optional(choice.speedup_ci95->lo) : std::nullopt, "{:.2f}"),
                     orDash(choice.speedup_ci95 ? std::optional(choice.speedup_ci95->hi) : std::nullopt, "{:.2f}"), orDash(choice.measured_error, "{:.4f}"),
                     orDash(choice.hit_rate, "{:.3f}"), orDash(limit, "{:.1f}"), percentOrDash(ratioOf(choice.measured_speedup, limit)),
                     line.published.published, line.published.asked ? fmt::format("{}", *line.published.asked) : "-", named, secondsOf(line.run));
}

nlohmann::json numberOrNull(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

nlohmann::json toJson(const Line& line) {
  const RunChoice& choice = line.run.choice;
  const bool varies = choice.kind == ChoiceKind::kVariant;
  const auto period = varies && choice.period_frames != 0 ? nlohmann::json(choice.period_frames) : nlohmann::json(nullptr);
  return {{"case", line.published.name},
          {"choice", nameOf(choice.kind)},
          {"reason", choice.reason},
          {"payload", payloadOf(choice)},
          {"strategy", choice.strategy},
          {"pattern", choice.pattern},
          {"block_pixels", choice.block_pixels},
          {"filter", choice.filter},
          {"encoding", choice.encoding},
          {"period_frames", period},
          {"speedup", varies ? numberOrNull(choice.measured_speedup) : nlohmann::json(1.0)},
          {"speedup_ci95", choice.speedup_ci95 ? nlohmann::json{choice.speedup_ci95->lo, choice.speedup_ci95->hi} : nlohmann::json(nullptr)},
          {"wall_speedup", numberOrNull(choice.wall_speedup)},
          {"validation_error", varies ? numberOrNull(choice.measured_error) : nlohmann::json(0.0)},
          {"hit_rate", numberOrNull(choice.hit_rate)},
          {"original_frame_ms", numberOrNull(line.run.original.frame_ms)},
          {"limit_frame_ms", numberOrNull(line.run.limit.frame_ms)},
          {"limit_speedup", numberOrNull(limitSpeedup(line.run))},
          {"share_of_limit", numberOrNull(ratioOf(choice.measured_speedup, limitSpeedup(line.run)))},
          {"predicted_error", numberOrNull(choice.predicted_error)},
          {"predicted_frame_ms", numberOrNull(choice.predicted_frame_ms)},
          {"measured_frame_ms", numberOrNull(choice.measured_frame_ms)},
          {"published", line.published.published},
          {"asked_speedup", numberOrNull(line.published.asked)},
          {"named_payload_rank", line.named_rank ? nlohmann::json(*line.named_rank) : nlohmann::json(nullptr)},
          {"seconds", secondsOf(line.run)}};
}

// The case's scenario at the benchmark's size, as a file of its own.
Result<std::filesystem::path> sizedScenario(const Bench& bench, const PublishedCase& one) {
  REPRISE_ASSIGN(Scenario scenario, readScenario(std::string(REPRISE_SOURCE_DIR) + "/shaders/" + one.scenario));
  scenario.width = bench.width;
  scenario.height = bench.height;
  const std::filesystem::path file = std::filesystem::absolute(bench.output) / (one.name + ".toml");
  REPRISE_TRY(writeFile(file, writeScenario(scenario, file.parent_path())));
  return file;
}

Result<Line> runCase(const Bench& bench, const PublishedCase& one) {
  REPRISE_ASSIGN(const std::filesystem::path scenario, sizedScenario(bench, one));
  OptimizeArguments arguments;
  arguments.scenario = scenario.string();
  DemandWords words;
  if (bench.quality.empty()) words.max_error = bench.max_error;
  words.quality = bench.quality;
  REPRISE_ASSIGN(arguments.demand, demandOf(words));
  arguments.budget_s = bench.budget_s;
  arguments.output = (std::filesystem::path(bench.output) / one.name).string();
  arguments.device = bench.device;
  arguments.worker_path = bench.worker_path;
  Progress progress(progressStyle(false));
  progress.say("case " + one.name);
  REPRISE_ASSIGN(RunResult run, optimize(arguments, progress));
  const auto rank = rankOfNamed(one, run.candidates);
  return Line{one, std::move(run), rank};
}

std::optional<double> medianMiss(const std::vector<Line>& lines, std::optional<double> (*miss)(const RunChoice&)) {
  std::vector<double> misses;
  for (const Line& line : lines)
    if (const auto one = miss(line.run.choice); one && std::isfinite(*one)) misses.push_back(std::abs(*one));
  return misses.empty() ? std::nullopt : std::optional<double>(medianOf(misses));
}

Result<void> makeTable(const Bench& bench, const std::vector<PublishedCase>& wanted) {
  std::vector<Line> lines;
  for (const PublishedCase& one : wanted) {
    Result<Line> line = runCase(bench, one);
    if (!line.ok()) return line.error();
    std::cerr << rowText(*line) << '\n';
    lines.push_back(std::move(*line));
  }
  const RunResult& first = lines.front().run;
  std::cout << fmt::format("Published cases, {}; {}; {}; clock: {}; {}x{}; at most {} rms; {:.0f} s of training each; reprise {}\n\n", first.device.name,
                           first.device.driver, first.device.host, first.clock, bench.width, bench.height, bench.max_error, bench.budget_s, kToolVersion)
            << "| case | payload | variant | period | speed-up [95%] | RMS error | hit rate | limit (share of it) | published | asked | place of the named payload | s |\n"
               "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  nlohmann::json cases = nlohmann::json::array();
  for (const Line& line : lines) {
    std::cout << rowText(line) << '\n';
    cases.push_back(toJson(line));
  }
  const auto error_miss = medianMiss(lines, [](const RunChoice& choice) { return missedBy(choice.predicted_error, choice.measured_error); });
  const auto time_miss = medianMiss(lines, [](const RunChoice& choice) { return missedBy(choice.predicted_frame_ms, choice.measured_frame_ms); });
  std::cout << fmt::format("\nPredictions, medians over the table: frame time off by {}, error off by {}.\n", percentOrDash(time_miss), percentOrDash(error_miss));
  if (bench.json_file.empty()) return {};
  const nlohmann::json document = {{"device", first.device.name}, {"driver", first.device.driver}, {"host", first.device.host}, {"clock", first.clock},
                                   {"width", bench.width}, {"height", bench.height}, {"max_error", bench.max_error}, {"quality", bench.quality}, {"budget_s", bench.budget_s},
                                   {"median_frame_time_miss", numberOrNull(time_miss)}, {"median_error_miss", numberOrNull(error_miss)}, {"cases", cases}};
  return writeFile(bench.json_file, document.dump(2) + "\n");
}

Result<void> makeRegretTable(const Bench& bench, const std::vector<PublishedCase>& wanted) {
  std::cout << "| case | regret | fastest found | its error | variants | within the threshold |\n|---|---|---|---|---|---|\n";
  std::vector<double> values;
  nlohmann::json cases = nlohmann::json::array();
  for (const PublishedCase& one : wanted) {
    RegretPlan plan;
    plan.directory = std::filesystem::path(bench.output) / one.name;
    plan.device = bench.device;
    plan.worker_path = bench.worker_path;
    REPRISE_ASSIGN(const Regret regret, measureRegret(plan));
    std::cout << fmt::format("| {} | {:.1f}% | {} | {:.4f} | {} | {} |\n", one.name, 100 * regret.value, regret.best, regret.best_error, regret.variants, regret.within_threshold)
              << std::flush;
    values.push_back(regret.value);
    cases.push_back({{"case", one.name}, {"regret", regret.value}, {"best", regret.best}, {"variants", regret.variants}, {"within_threshold", regret.within_threshold}});
  }
  std::cout << fmt::format("\nMedian regret {:.1f}%, most {:.1f}%.\n", 100 * medianOf(values), 100 * *std::max_element(values.begin(), values.end()));
  if (bench.json_file.empty()) return {};
  return writeFile(bench.json_file, nlohmann::json{{"cases", cases}}.dump(2) + "\n");
}

}  // namespace
}  // namespace reprise

int main(int argc, char** argv) {
  reprise::Bench bench;
  CLI::App app("Takes the published cases through `optimize` and prints one table");
  std::vector<std::string> names;
  for (const reprise::PublishedCase& one : reprise::publishedCases()) names.push_back(one.name);
  app.add_option("--cases", bench.cases, "only these")->check(CLI::IsMember(names))->delimiter(',');
  app.add_option("--json", bench.json_file, "write the rows to a file too");
  app.add_option("-o,--output", bench.output, "where the runs are kept")->capture_default_str();
  app.add_option("--device", bench.device, "index or part of the name");
  app.add_option("--budget", bench.budget_s, "seconds of training for each case")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--quality", bench.quality, "a level in place of an RMS");
  app.add_option("--max-error", bench.max_error, "RMS")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--width", bench.width)->check(CLI::Range(1, 8192))->capture_default_str();
  app.add_option("--height", bench.height)->check(CLI::Range(1, 8192))->capture_default_str();
  app.add_flag("--regret", bench.regret, "of the runs in --output: how much slower each choice is than the best of four candidates, all strategies, four periods");
  CLI11_PARSE(app, argc, argv);
  std::vector<reprise::PublishedCase> wanted;
  for (const reprise::PublishedCase& one : reprise::publishedCases())
    if (bench.cases.empty() || std::find(bench.cases.begin(), bench.cases.end(), one.name) != bench.cases.end()) wanted.push_back(one);
  bench.worker_path = (std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / "reprise").string();
  const reprise::Result<void> result = bench.regret ? reprise::makeRegretTable(bench, wanted) : reprise::makeTable(bench, wanted);
  if (result.ok()) return 0;
  std::cerr << reprise::formatError(result.error()) << '\n';
  return 1;
}
