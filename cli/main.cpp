// The command line: words to arguments, errors to messages and exit statuses. What is done lies in commands/ and pipeline.cpp.
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iostream>

#include "cli/check/reference/reference.h"
#include "cli/check/run_modules.h"
#include "cli/choice.h"
#include "cli/commands/analyze.h"
#include "cli/commands/check.h"
#include "cli/commands/devices.h"
#include "cli/commands/emit.h"
#include "cli/commands/play.h"
#include "cli/pipeline.h"
#include "cli/report/text.h"
#include "cli/report_error.h"
#include "cli/report_directory.h"
#include "cli/usage.h"
#include "cli/version.h"
#include "profiler/metrics/metrics.h"
#include "profiler/metrics/quality.h"
#include "profiler/session/job.h"

namespace reprise {
namespace {

std::atomic<bool> interrupt_seen{false};

void onInterrupt(int) { interrupt_seen = true; }

// For the commands that ask for `interrupt_seen`; the others end at once.
void catchInterrupts() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(number, onInterrupt);
    if (number == SIGHUP && before == SIG_IGN) std::signal(number, SIG_IGN);  // nohup
  }
}

int report(const Error& error, bool as_json) { return reportError(error, as_json, std::cerr); }

struct Words {
  bool quiet = false;
  std::string error_format = "text";
  std::string device;
  OptimizeArguments optimize;
  DemandWords demand;
  std::string budget;
  AnalyzeArguments analyze;
  CheckArguments check;
  std::vector<std::string> defines, includes;
  bool write_dependencies = false;
  PlayArguments play;
  EmitArguments emit;
  CommittedArguments committed;
  std::string validate_output;
  std::string on_stale = "fail";
  std::string period;
  std::string directory;
  std::string report_format = "html";
  bool json = false;

  bool errorsAsJson() const { return error_format == "json"; }
};

// "120s", "2m", "90": seconds; negative if it is none of these.
double secondsFrom(const std::string& text) {
  if (text.empty()) return 0;
  std::size_t used = 0;
  double value = -1;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    return -1;
  }
  const std::string unit = text.substr(used);
  if (unit.empty() || unit == "s") return value;
  return unit == "m" ? value * 60 : -1;
}

std::string executablePath() {
  std::error_code status;
  return std::filesystem::read_symlink("/proc/self/exe", status).string();
}

int runOptimize(Words& words, const std::string& command) {
  OptimizeArguments& arguments = words.optimize;
  arguments.device = words.device;
  arguments.command = command;
  arguments.worker_path = executablePath();
  arguments.interrupted = [] { return interrupt_seen.load(); };
  arguments.budget_s = secondsFrom(words.budget);
  if (arguments.budget_s < 0)
    return report({ErrorKind::kUsage, "budget.value", "--budget is '" + words.budget + "'; it must be a time such as 120s or 2m", {}}, words.errorsAsJson());
  Result<Demand> demand = demandOf(words.demand);
  if (!demand.ok()) return report(demand.error(), words.errorsAsJson());
  arguments.demand = std::move(*demand);
  Progress progress(progressStyle(words.quiet));
  const Result<RunResult> result = optimize(arguments, progress);
  if (!result.ok()) return report(result.error(), words.errorsAsJson());
  std::cout << summaryText(*result);
  if (!words.quiet) std::cout << "report: " << (std::filesystem::path(arguments.output) / "report.html").string() << '\n';
  return result->choice.kind == ChoiceKind::kUndecided ? kUndecidedStatus : 0;
}

// The scenario of a committed choice: the one named, that of an output directory, or the one beside the choice.
Result<std::string> scenarioOfChoice(const Words& words) {
  namespace fs = std::filesystem;
  if (!words.directory.empty())
    return fs::is_directory(words.directory) ? (fs::path(words.directory) / "scenario" / "scenario.toml").string() : words.directory;
  REPRISE_ASSIGN(const Choice choice, readChoice(words.committed.choice));
  return (fs::path(words.committed.choice).parent_path() / choice.scenario_file).string();
}

int runValidateChoice(Words& words) {
  namespace fs = std::filesystem;
  const Result<std::string> scenario = scenarioOfChoice(words);
  if (!scenario.ok()) return report(scenario.error(), words.errorsAsJson());
  words.committed.scenario = *scenario;
  std::error_code status;
  const bool own_folder = words.validate_output.empty();
  words.optimize.output =
      own_folder ? (fs::temp_directory_path(status) / ("reprise-validate-" + std::to_string(::getpid()))).string() : words.validate_output;
  Progress progress(progressStyle(words.quiet));
  const Result<CommittedCheck> check = validateCommitted(words.committed, words.optimize, progress);
  if (own_folder) fs::remove_all(words.optimize.output, status);
  if (!check.ok()) return report(check.error(), words.errorsAsJson());
  if (!check->note.empty()) std::cerr << "note: " << check->note << '\n';
  std::cout << check->sentence << '\n';
  return 0;
}

int runValidate(Words& words, const std::string& command) {
  words.optimize.command = command;
  words.optimize.device = words.device;
  words.optimize.worker_path = executablePath();
  words.optimize.interrupted = [] { return interrupt_seen.load(); };
  if (!words.committed.choice.empty()) return runValidateChoice(words);
  if (words.directory.empty())
    return report({ErrorKind::kUsage, "validate.directory", "name the output directory of a run, or a choice with --choice", {}}, words.errorsAsJson());
  Progress progress(progressStyle(words.quiet));
  const Result<RunResult> result = validateAgain(words.directory, words.optimize, progress);
  if (!result.ok()) return report(result.error(), words.errorsAsJson());
  std::cout << result->choice.reason << '\n';
  return 0;
}

int runReport(const Words& words) {
  if (words.report_format == "html") {
    const Result<void> result = reportAgain(words.directory);
    return result.ok() ? 0 : report(result.error(), words.errorsAsJson());
  }
  const Result<std::string> text = reportText(words.directory, words.report_format);
  if (!text.ok()) return report(text.error(), words.errorsAsJson());
  std::cout << *text;
  return 0;
}

int runAnalyze(Words& words) {
  for (const std::string& define : words.defines) {
    const std::size_t equals = define.find('=');
    words.analyze.compile.defines.emplace_back(define.substr(0, equals), equals == std::string::npos ? "" : define.substr(equals + 1));
  }
  for (const std::string& directory : words.includes) words.analyze.compile.include_dirs.emplace_back(directory);
  words.analyze.json = words.json;
  if (words.write_dependencies && words.analyze.depfile.empty()) words.analyze.depfile = words.analyze.shader + ".d";
  const Result<void> result = analyzeShader(words.analyze, std::cout);
  return result.ok() ? 0 : report(result.error(), words.errorsAsJson());
}

int runPlay(Words& words) {
  words.play.device = words.device;
  if (words.period == "never") {
    words.play.period_frames = 0;
  } else if (!words.period.empty()) {
    char* end = nullptr;
    const unsigned long period = std::strtoul(words.period.c_str(), &end, 10);
    if (*end != '\0' || period == 0 || period > 64 || (period & (period - 1)) != 0)
      return report({ErrorKind::kUsage, "period.value", "--period is '" + words.period + "'; it must be 1, 2, 4, ... 64 or never", {}}, words.errorsAsJson());
    words.play.period_frames = static_cast<std::uint32_t>(period);
  }
  const Result<void> result = playPackage(words.play, std::cout);
  return result.ok() ? 0 : report(result.error(), words.errorsAsJson());
}

int runEmit(Words& words) {
  words.emit.on_stale = words.on_stale == "original" ? OnStale::kOriginal : OnStale::kFail;
  if (words.write_dependencies && words.emit.depfile.empty())
    words.emit.depfile = (words.emit.output.empty() ? words.emit.header : words.emit.output) + ".d";
  words.emit.device = words.device;
  words.emit.worker_path = executablePath();
  words.emit.interrupted = [] { return interrupt_seen.load(); };
  const Result<void> result = emitChoice(words.emit, std::cout, std::cerr);
  return result.ok() ? 0 : report(result.error(), words.errorsAsJson());
}

int runCheck(Words& words) {
  CheckArguments& arguments = words.check;
  arguments.request.device = words.device;
  arguments.request.include_dirs = words.includes;
  arguments.request.defines = words.defines;
  arguments.json = words.json;
  arguments.quiet = words.quiet;
  arguments.worker_path = executablePath();
  arguments.interrupted = [] { return interrupt_seen.load(); };
  const Result<bool> result = checkShaders(arguments, std::cout, std::cerr);
  if (!result.ok()) return report(result.error(), words.errorsAsJson());
  return *result ? 0 : kInputStatus;
}

std::string levelNames() {
  std::string names;
  for (const Quality& quality : qualities()) names += (names.empty() ? "" : ", ") + quality.name;
  return names;
}

void addOptimize(CLI::App& app, Words& words) {
  CLI::App* command = app.add_subcommand("optimize", "find, measure and package the fastest variant under an error threshold");
  command->add_option("scenario", words.optimize.scenario, "TOML file (docs/scenario.md), or a glTF model (.gltf, .glb)")->required();
  command->add_option("--quality", words.demand.quality, "level of quality: " + levelNames() + "; " + kDefaultQuality + " where nothing else is allowed");
  command->add_option("--max", words.demand.max, "METRIC=VALUE, the most that a metric may be; may be given several times, and all bind: " + metricNames())
      ->allow_extra_args(false);
  command->add_option("--max-error", words.demand.max_error, "the same of the metric of --metric");
  command->add_option("--metric", words.demand.metric, "of --max-error; rms where none is named");
  command->add_option("--min-gain", words.optimize.least_gain, "speed-up that a variant must exceed beyond the noise")->capture_default_str();
  command->add_option("--budget", words.budget,
                      "time that the run may take from when it holds the device, validation and report included, such as 120s or 2m; as long as it takes where none is given");
  command->add_option("-o,--output", words.optimize.output, "directory of the results")->capture_default_str();
}

void addAnalyze(CLI::App& app, Words& words) {
  CLI::App* command = app.add_subcommand("analyze", "list the values of a fragment shader that are worth caching, and why others are not");
  command->add_option("shader", words.analyze.shader, "GLSL, HLSL (.hlsl) or SPIR-V, - for standard input")->required();
  command->add_flag("--json", words.json, "JSON instead of text");
  command->add_flag("--all", words.analyze.all, "list the values that are no candidates one by one");
  command->add_flag("--annotate", words.analyze.annotate, "the source with the share of cost of each line and the candidates in the margin");
  command->add_option("-I", words.includes, "directory for #include")->allow_extra_args(false);
  command->add_option("-D", words.defines, "NAME or NAME=VALUE")->allow_extra_args(false);
  command->add_option("--std", words.analyze.compile.standard, "GLSL version, such as 450");
  command->add_option("--entry-point", words.analyze.compile.entry_point, "of SPIR-V with several")->capture_default_str();
  command->add_flag("--MD", words.write_dependencies, "write the included files as a make rule");
  command->add_option("--MF", words.analyze.depfile, "file for -MD");
}

void addCheck(CLI::App& app, Words& words) {
  CLI::App* command = app.add_subcommand("check", "test the rewrites of shaders against their originals, on this device and made-up inputs");
  command->add_option("shaders", words.check.shaders, "GLSL, HLSL (.hlsl), SPIR-V, SPIR-V assembly (.spvasm), or directories of them")->required();
  command->add_flag("--json", words.json, "JSON instead of text");
  command->add_option("--jobs,-j", words.check.jobs, "modules at once; 0: as many as there are cores")->check(expectNotNegative)->capture_default_str();
  command->add_option("--seed", words.check.request.seed, "of the made-up inputs")->capture_default_str();
  command->add_option("--candidates", words.check.request.candidates, "how many of the best ones")->check(expectPositive)->capture_default_str();
  command->add_option("--strategy", words.check.request.strategy, "only this one");
  command->add_option("--timeout", words.check.module_timeout_s, "seconds for a module")->check(expectPositive)->capture_default_str();
  command->add_option("-I", words.includes, "directory for #include")->allow_extra_args(false);
  command->add_option("-D", words.defines, "NAME or NAME=VALUE")->allow_extra_args(false);
  command->add_option("--entry-point", words.check.request.entry_point, "of SPIR-V with several")->capture_default_str();
}

void addPlay(CLI::App& app, Words& words) {
  CLI::App* command = app.add_subcommand("play", "play a package: frames to PNG or hashes");
  command->add_option("directory", words.play.directory, "a package, or the output of optimize")->required();
  command->add_option("--scenario", words.play.scenario, "TOML file; that of the output where there is one");
  command->add_option("--session", words.play.session, "the first validation session if none is named");
  command->add_option("--frames", words.play.frames, "number of frames; the session's if none is named");
  command->add_option("--period", words.period, "1, 2, 4, ... 64 or never; the package's if none is named");
  command->add_flag("--original", words.play.original, "the original instead of the variant");
  command->add_option("--png", words.play.png_dir, "directory for the frames");
  command->add_flag("--hashes", words.play.hashes, "print a hash of every frame");
}

void addEmit(CLI::App& app, Words& words) {
  CLI::App* command = app.add_subcommand("emit", "make the package of a choice from the sources again, without a device or training");
  command->add_option("scenario", words.emit.scenario, "TOML file (docs/scenario.md)")->required();
  command->add_option("--choice", words.emit.choice, "choice.json of an optimize run")->required();
  command->add_option("-o,--output", words.emit.output, "directory of the package");
  command->add_option("--header", words.emit.header, "the package as a C++ header");
  command->add_option("--name", words.emit.header_name, "of the package in the header")->capture_default_str();
  command->add_option("--on-stale", words.on_stale, "fail or original: what to do where the payload has changed")
      ->check(CLI::IsMember({"fail", "original"}))->capture_default_str();
  command->add_option("--quality", words.emit.asked.quality, "fail unless the choice binds what this level does: " + levelNames());
  command->add_option("--max", words.emit.asked.max, "METRIC=VALUE, fail unless the choice allows the metric at most this; may be given several times")
      ->allow_extra_args(false);
  command->add_option("--max-error", words.emit.asked.max_error, "the same of the metric of --metric");
  command->add_option("--metric", words.emit.asked.metric, "of --max-error; rms where none is named");
  command->add_flag("--verify", words.emit.verify, "compare the package with the original first, on a device; write nothing where they differ");
  command->add_flag("--M", words.emit.list_dependencies, "print what the package depends on as a make rule, and make nothing");
  command->add_flag("--MD", words.write_dependencies, "write that rule beside the output");
  command->add_option("--MF", words.emit.depfile, "file for -MD");
  command->add_option("--MT", words.emit.depfile_target, "target of the rule; else the output");
}

int run(int argc, char** argv) {
  Words words;
  CLI::App app("Reprise: caches the expensive part of a fragment shader from frame to frame, with measured error and gain", "reprise");
  app.formatter(helpFormatter());
  app.set_version_flag("--version", versionText);
  app.require_subcommand(1);
  app.fallthrough();
  app.add_flag("--quiet,-q", words.quiet, "no progress");
  app.add_option("--error-format", words.error_format, "text or json")->check(CLI::IsMember({"text", "json"}));
  app.add_option("--device", words.device, "index or part of the name (reprise devices)");
  addOptimize(app, words);
  addAnalyze(app, words);
  addCheck(app, words);
  addPlay(app, words);
  addEmit(app, words);
  CLI::App* validate = app.add_subcommand("validate", "measure the choice of an output directory again, on this device");
  validate->add_option("directory", words.directory, "output of optimize; with --choice the scenario, that beside the choice if none is named");
  validate->add_option("--choice", words.committed.choice, "choice.json: measure it on the sources as they are now");
  validate->add_option("--cost-tolerance", words.committed.cost_tolerance, "how much more than recorded it may cost, as a share")
      ->check(expectNotNegative)->capture_default_str();
  validate->add_option("-o,--output", words.validate_output, "directory for what is measured of --choice; else a temporary one");
  CLI::App* report_command = app.add_subcommand("report", "write the report of an output directory again");
  report_command->add_option("directory", words.directory)->required();
  report_command->add_option("--format", words.report_format, "html (DIR/report.html), or markdown or csv to standard output")
      ->check(CLI::IsMember({"html", "markdown", "csv"}))->capture_default_str();
  CLI::App* devices = app.add_subcommand("devices", "list the Vulkan devices");
  devices->add_flag("--json", words.json, "JSON instead of text");
  app.add_subcommand("worker", "")->group("");
  app.add_subcommand("check-worker", "")->group("");
  app.add_subcommand("check-reference", "")->group("");
  const std::vector<std::string> line(argv + 1, argv + argc);
  try {
    std::vector<std::string> spelled = spelledForParser(line);
    std::reverse(spelled.begin(), spelled.end());  // as CLI11 takes them
    app.parse(spelled);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return report(usageError(app, error, line), wantsJsonErrors(line));
  }
  for (const char* each : {"optimize", "emit", "validate", "check"})
    if (app.got_subcommand(each)) catchInterrupts();
  std::string command = "reprise";
  for (const std::string& word : line) command += " " + word;
  if (app.got_subcommand("worker")) return runWorker();
  if (app.got_subcommand("check-worker")) return runCheckWorker(executablePath());
  if (app.got_subcommand("check-reference")) return runReferenceWorker();
  if (app.got_subcommand("check")) return runCheck(words);
  if (app.got_subcommand("optimize")) return runOptimize(words, command);
  if (app.got_subcommand("emit")) return runEmit(words);
  if (app.got_subcommand("analyze")) return runAnalyze(words);
  if (app.got_subcommand("play")) return runPlay(words);
  if (app.got_subcommand(validate)) return runValidate(words, command);
  if (app.got_subcommand(report_command)) return runReport(words);
  const Result<void> result = listDevicesCommand(words.json, std::cout);
  return result.ok() ? 0 : report(result.error(), words.errorsAsJson());
}

}  // namespace
}  // namespace reprise

int main(int argc, char** argv) { return reprise::run(argc, argv); }
