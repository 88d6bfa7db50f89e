// bench/tool_times: how long people wait for the tool where nothing is measured: packages from committed choices, and a report's first paint.
//
// Times are medians of wall time over --rounds runs of the built executable, each into a new folder; no device is used. First paint: from the
// start of the navigation to the first contentful paint, as headless Chromium traces it, a new browser each time.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/trained.h"
#include "cli/version.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBrowser = "/usr/bin/chromium --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking --disable-sync";

struct Bench {
  std::string tool, report;
  int rounds = 10;
  fs::path folder;
};

Error failed(const std::string& command) { return {ErrorKind::kMachine, "bench.command", "this command failed: " + command, {}}; }

std::string shellWord(const fs::path& path) { return "'" + path.string() + "'"; }

Result<double> secondsOf(const std::string& command) {
  const auto before = std::chrono::steady_clock::now();
  if (std::system((command + " > /dev/null 2>&1").c_str()) != 0) return failed(command);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
}

// The median time of emitting all of them, one after the other.
Result<double> emitSeconds(const Bench& bench, const std::vector<std::string>& scenarios) {
  std::vector<double> sums;
  for (int round = 0; round < bench.rounds; ++round) {
    double sum = 0;
    for (const std::string& scenario : scenarios) {
      const fs::path base = fs::path(REPRISE_SOURCE_DIR) / scenario, output = bench.folder / "package";
      fs::remove_all(output);
      REPRISE_ASSIGN(const double seconds, secondsOf(shellWord(bench.tool) + " emit " + shellWord(base.string() + ".toml") + " --choice " +
                                                     shellWord(base.string() + ".choice.json") + " -o " + shellWord(output)));
      sum += seconds;
    }
    sums.push_back(sum);
  }
  return medianOf(sums);
}

// Of the main frame's first navigation; nullopt if the trace has none.
std::optional<double> firstPaintIn(const nlohmann::json& trace) {
  std::optional<double> navigated, painted;
  for (const auto& event : trace.value("traceEvents", nlohmann::json::array())) {
    const std::string name = event.value("name", "");
    if (name == "firstContentfulPaint" && !painted) painted = event.value("ts", 0.0);
    if (name == "navigationStart" && event.value("/args/data/documentLoaderURL"_json_pointer, "").starts_with("file:")) navigated = event.value("ts", 0.0);
  }
  if (!navigated || !painted) return std::nullopt;
  return (*painted - *navigated) * 1e-6;
}

Result<double> firstPaintSeconds(const Bench& bench) {
  std::vector<double> times;
  for (int round = 0; round < bench.rounds; ++round) {
    const fs::path trace = bench.folder / "trace.json", profile = bench.folder / "profile";
    fs::remove_all(profile);
    const std::string command = std::string(kBrowser) + " --user-data-dir=" + shellWord(profile) + " --trace-startup=blink.user_timing,loading --trace-startup-format=json --trace-startup-file=" +
                                shellWord(trace) + " --screenshot=" + shellWord(bench.folder / "shot.png") + " " + shellWord("file://" + fs::absolute(bench.report).string());
    REPRISE_TRY(secondsOf(command));
    REPRISE_ASSIGN(const std::string text, readFile(trace));
    const std::optional<double> seconds = firstPaintIn(nlohmann::json::parse(text, nullptr, false));
    if (!seconds) return Error{ErrorKind::kMachine, "bench.trace", "the browser's trace tells of no first paint", {}};
    times.push_back(*seconds);
  }
  return medianOf(times);
}

Result<void> run(const Bench& bench) {
  std::cout << fmt::format("Waiting for the tool, medians of {} runs; reprise {}\n\n| what | measured | asked |\n|---|---|---|\n", bench.rounds, kToolVersion);
  REPRISE_ASSIGN(const double marble, emitSeconds(bench, {"shaders/marble/marble20"}));
  std::cout << fmt::format("| emit, marble of 20 octaves | {:.2f} s | 0.5 s |\n", marble);
  const std::string example = "examples/cmake_project/shaders/";
  REPRISE_ASSIGN(const double three, emitSeconds(bench, {example + "granite", example + "agate", example + "wood"}));
  std::cout << fmt::format("| emit, the three shaders of examples/cmake_project | {:.2f} s | 3 s |\n", three);
  if (bench.report.empty()) return {};
  REPRISE_ASSIGN(const double painted, firstPaintSeconds(bench));
  std::cout << fmt::format("| report, first paint | {:.2f} s | 1 s |\n| report, size | {:.2f} MB | 6 MB |\n", painted, static_cast<double>(fs::file_size(bench.report)) * 1e-6);
  return {};
}

}  // namespace
}  // namespace reprise

int main(int argc, char** argv) {
  reprise::Bench bench;
  CLI::App app("Times what people wait for where nothing is measured: emit and the report's first paint");
  app.add_option("--report", bench.report, "a report.html whose first paint is timed, too; needs chromium")->check(CLI::ExistingFile);
  app.add_option("--rounds", bench.rounds, "runs of each")->check(CLI::PositiveNumber)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  bench.tool = (std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / "reprise").string();
  bench.folder = std::filesystem::temp_directory_path() / fmt::format("reprise-tool-times-{}", ::getpid());
  std::filesystem::create_directories(bench.folder);
  const reprise::Result<void> result = reprise::run(bench);
  std::error_code status;
  std::filesystem::remove_all(bench.folder, status);
  if (result.ok()) return 0;
  std::cerr << reprise::formatError(result.error()) << '\n';
  return 1;
}
