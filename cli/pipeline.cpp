#include "cli/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "cli/answer.h"
#include "cli/budget.h"
#include "cli/describe_evidence.h"
#include "cli/describe_run.h"
#include "cli/device_lock.h"
#include "cli/evidence_pictures.h"
#include "cli/fit.h"
#include "cli/measured_device.h"
#include "cli/model_scenario.h"
#include "cli/motion.h"
#include "cli/open_bench.h"
#include "cli/package_of_choice.h"
#include "cli/report_directory.h"
#include "cli/smear_warnings.h"
#include "cli/studied_periods.h"
#include "cli/subject.h"
#include "cli/train.h"
#include "cli/validate_choice.h"
#include "cli/version.h"
#include "cli/workspace.h"
#include "compiler/emit/emit.h"
#include "fitting/selection/next_turn.h"
#include "profiler/metrics/metrics.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

constexpr std::size_t kMostAttempts = 16;

class StageClock {
 public:
  StageClock(RunResult& result, const Progress& progress) : result_(result), progress_(progress) {}
  // Returns the seconds that it took.
  double end(const std::string& stage) {
    const double now = progress_.elapsedSeconds(), taken = now - last_;
    result_.seconds.push_back({stage, taken});
    last_ = now;
    return taken;
  }

 private:
  RunResult& result_;
  const Progress& progress_;
  double last_ = 0;
};

Result<void> checkArguments(const OptimizeArguments& arguments) {
  REPRISE_CHECK(!arguments.demand.binding.thresholds.empty(), "nothing binds: make the demand with demandOf");
  if (!(arguments.least_gain >= 1) || !std::isfinite(arguments.least_gain))
    return Error{ErrorKind::kUsage, "gain.value", fmt::format("--min-gain is {}; it must be a number of at least 1, such as 1.05", arguments.least_gain), {}};
  return {};
}

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

// What is known before anything is measured.
RunResult describeSubject(const Subject& subject, const OptimizeArguments& arguments, const MeasuredDevice& measured) {
  RunResult result;
  result.tool_version = kToolVersion;
  result.device = describeDevice(measured, processorName());
  result.clock = measured.summary.is_cpu ? "process_cpu" : "timestamps";
  result.shader = {subject.scenario.fragment_path, subject.scenario.vertex_path, subject.program.hash};
  int frames = 0;
  for (const SessionSpec& session : subject.scenario.sessions)
    if (session.role == SessionRole::kTraining) frames += session.frames > 0 ? session.frames : subject.scenario.frames;
  result.scenario = {arguments.scenario, subject.scenario.name, subject.scenario.hash, subject.scenario.width, subject.scenario.height,
                     subject.scenario.seed, frames, std::nullopt};
  if (subject.scenario.stereo) result.scenario.eye_distance = static_cast<double>(subject.scenario.stereo->eye_distance);
  result.quality = arguments.demand.quality;
  for (const Threshold& threshold : arguments.demand.binding.thresholds) result.thresholds.push_back({threshold.metric, threshold.value});
  result.threshold = {arguments.demand.binding.unit(), arguments.demand.binding.limit()};
  result.least_gain = arguments.least_gain;
  result.command = arguments.command;
  return result;
}

Result<DeviceLock> lockDevice(const DeviceSummary& device, const OptimizeArguments& arguments, Progress& progress) {
  return DeviceLock::take(device.name, arguments.command.empty() ? "reprise" : arguments.command,
                          {[&](const std::string& holder) { progress.sayAlways("waiting for " + device.name + ", which another run measures on (" + holder + ")"); },
                           arguments.interrupted});
}

BenchOptions benchOptions(const OptimizeArguments& arguments) { return {arguments.device, arguments.worker_path, arguments.demand.planning.metrics(), arguments.interrupted}; }

struct Validated {
  std::vector<ValidationAttempt> attempts;
  std::optional<std::size_t> accepted;  // index into attempts
  bool budget_ended = false;            // before the next attempt was judged
  bool more_to_try = false;             // where kMostAttempts were made

  // A variant that a law rules out has been measured.
  bool noneMeasured() const {
    return !attempts.empty() && std::all_of(attempts.begin(), attempts.end(), [](const ValidationAttempt& one) { return one.run.judgement.code == "judge.unmeasured"; });
  }
  const ValidationAttempt& chosen() const { return attempts[accepted.value()]; }
  const ValidationAttempt& shown() const { return accepted ? chosen() : attempts.back(); }
};

// In the order of nextTurn. The first that keeps the threshold and is faster is taken (law 7), unless it is much slower than predicted: then
// its model was wrong, and the next ones get their turn as long as more is predicted of them than was measured.
Result<Validated> validateInOrder(const Subject& subject, const Workspace& workspace, const Measuring& measuring, const Training& training,
                                  const FittedTraining& fitted, const Selection& selection, const ValidationPlan& base, Progress& progress) {
  Validated validated;
  std::vector<Turn> turns;
  while (validated.attempts.size() < kMostAttempts) {
    const std::optional<std::size_t> place = nextTurn({fitted.input.configurations, selection.ranking, base.limits.limit()}, turns);
    if (!place) return validated;
    const TradeoffPoint& point = selection.ranking[*place];
    if (validated.accepted) {
      const ValidationAttempt& best = validated.chosen();
      if (!worthAnother({best.point.predicted_speedup, best.run.binding.ratio}, point.predicted_speedup)) return validated;
    }
    const ErrorStudy& study = training.errors[training.costs[fitted.cost_study[point.configuration]].error_study];
    ValidationPlan plan = base;
    plan.candidate = study.candidate;
    plan.options = study.options;
    plan.options.instrumented = false;
    plan.options.strategy = fitted.input.configurations[point.configuration].strategy;
    plan.options.period_frames = point.period_frames;
    Result<ValidationRun> run = validateChoice(subject, workspace, measuring, plan, progress);
    if (!run.ok() && run.error().code == kBudgetEnded) {
      validated.budget_ended = true;
      return validated;
    }
    if (!run.ok()) return run.error();
    validated.attempts.push_back({point.configuration, point, std::move(*run)});
    const ValidationAttempt& last = validated.attempts.back();
    progress.say(fmt::format("  {}", last.run.judgement.reason));
    const std::optional<double> too_large = last.run.judgement.code == "judge.error" ? std::optional(last.run.worst_session_error) : std::nullopt;
    turns.push_back({*place, last.run.judgement.accepted, too_large});
    if (last.run.judgement.accepted &&
        (!validated.accepted || last.run.binding.ratio > validated.chosen().run.binding.ratio))
      validated.accepted = validated.attempts.size() - 1;
  }
  validated.more_to_try = true;
  return validated;
}

// What the accepted attempt played; none where the original is the answer.
std::optional<ChosenVariant> chosenVariant(const Subject& subject, const Training& training, const FittedTraining& fitted, const Validated& validated) {
  if (!validated.accepted) return std::nullopt;
  const ValidationAttempt& attempt = validated.chosen();
  const ErrorStudy& study = training.errors[training.costs[fitted.cost_study[attempt.configuration]].error_study];
  ChosenVariant variant{subject.candidates[study.candidate], study.options};
  variant.options.instrumented = false;
  variant.options.strategy = fitted.input.configurations[attempt.configuration].strategy;
  variant.options.period_frames = attempt.point.period_frames;
  return variant;
}

// Pictures are for people: where a variant crashes over them the run stands, with a warning.
Result<RunEvidence> gatherEvidence(const PictureSubject& in, const Selection& selection, const Validated& validated, RunResult& result) {
  RunEvidence evidence;
  evidence.sources = describeSources(in.subject.program);
  evidence.slices = describeSlices(in.subject.program, in.subject.candidates, evidence.sources);
  evidence.costs = describeCosts(in.training, in.fitted);
  std::optional<TradeoffPoint> choice;
  if (validated.accepted) choice = validated.chosen().point;
  const auto session = std::find_if(in.subject.scenario.sessions.begin(), in.subject.scenario.sessions.end(),
                                    [](const SessionSpec& one) { return one.role == SessionRole::kValidation; });
  if (session == in.subject.scenario.sessions.end()) return evidence;
  const std::vector<TradeoffPoint> points = pointsToShow(choice, selection, in.fitted, result.threshold.value);
  if (const Result<void> made = makePictures(in, points, session->name, evidence); !made.ok()) {
    if (made.error().kind != ErrorKind::kMeasurement && made.error().code != kBudgetEnded) return made.error();
    result.warnings.push_back("no pictures: " + made.error().message);
    return evidence;
  }
  if (!choice) return evidence;
  const EvidencePictures& shown = evidence.pictures.front();
  result.images = {evidence.original, shown.cached, shown.error, shown.hit_miss, evidence.session, evidence.frame, kImageErrorGain,
                   kHitColorText, kMissColorText};
  return evidence;
}

// What the models themselves say against the choice, and what is known to smear before anything is measured.
void addWarnings(const Subject& subject, const Selection& selection, const FittedTraining& fitted, RunResult& result) {
  for (const TradeoffPoint& point : selection.pareto) result.front.push_back(describeVariant(fitted.input.configurations[point.configuration], point.period_frames));
  std::vector<std::string> ids{result.choice.candidate_id};
  for (const RunVariant& variant : result.front) ids.push_back(variant.candidate_id);
  if (subject.program.analysis.derivatives_read_buffers && result.device.lanes && !result.device.lanes->helper)
    result.warnings.push_back("the shader takes derivatives of what it reads from storage buffers, and on this device pixels beside a triangle read nothing there: "
                              "the original is wrong at the borders of triangles, and errors that come of it are not the payload's");
  for (std::string& warning : smearWarnings(subject, ids)) result.warnings.push_back(std::move(warning));
  for (std::string& warning : fitWarnings(result)) result.warnings.push_back(std::move(warning));
}

void describeOriginal(const Training& training, const Selection& selection, const Validated& validated, RunResult& result) {
  std::vector<double> clock, wall, prepass;
  for (const TimedFrame& frame : training.original) clock.push_back(frame.clock_ms), wall.push_back(frame.wall_ms);
  for (const TimedFrame& frame : training.prepass) prepass.push_back(frame.clock_ms);
  const auto known = [](double value) { return std::isfinite(value) ? std::optional<double>(value) : std::nullopt; };
  result.original = {known(medianOf(clock)), known(medianOf(wall)), known(medianOf(prepass))};
  if (!validated.attempts.empty()) {
    const ValidationRun& run = validated.shown().run;
    if (std::isfinite(run.original_ms)) result.original = {known(run.original_ms), known(run.original_wall_ms), known(run.prepass_ms)};
  }
  if (validated.accepted) return;
  const Answer answer = answerWithoutVariant(result, {selection, training.budget_ended || validated.budget_ended, validated.noneMeasured(), validated.more_to_try});
  result.choice.kind = answer.kind;
  result.choice.reason = answer.reason;
}

// What is undecided leaves no choice, not that of an earlier run either.
Result<void> writeChoice(const Workspace& workspace, const Subject& subject, const ChosenVariant* chosen, const RunResult& result) {
  const std::filesystem::path file = workspace.root() / "choice.json";
  if (result.choice.kind != ChoiceKind::kUndecided) return writeFile(file, choiceToJson(describeChoice(subject, chosen, result)));
  std::error_code gone;
  std::filesystem::remove(file, gone);
  return {};
}

// A model that comes alone gets a scenario of its own, in the workspace.
Result<Subject> subjectOf(const OptimizeArguments& arguments) {
  if (!isModelFile(arguments.scenario)) return readSubject(arguments.scenario);
  REPRISE_ASSIGN(const std::string text, modelScenario(arguments.scenario));
  const std::filesystem::path made = std::filesystem::path(arguments.output) / "work" / "model.toml";
  REPRISE_TRY(writeFile(made, text));
  return readSubject(made);
}

}  // namespace

Result<RunResult> optimize(const OptimizeArguments& arguments, Progress& progress) {
  REPRISE_TRY(checkArguments(arguments));
  REPRISE_ASSIGN(Subject subject, subjectOf(arguments));                                        // 1 compile .. 4 enumerate
  REPRISE_ASSIGN(const MeasuredDevice measured, openMeasuredDevice(arguments.device));
  const DeviceSummary& device = measured.summary;
  limitTo(measured, subject);
  REPRISE_ASSIGN(const Workspace workspace, Workspace::open(arguments.output));
  REPRISE_TRY(copyInputs(subject, workspace.scenarioFile()));
  const std::vector<std::string> short_sessions = shortSessionWarnings(subject.scenario);
  for (const std::string& warning : short_sessions) progress.say(warning);
  RunResult result = describeSubject(subject, arguments, measured);
  StageClock clock(result, progress);
  clock.end("compile");

  REPRISE_ASSIGN(const DeviceLock lock, lockDevice(device, arguments, progress));
  clock.end("wait for the device");
  const Budget budget(arguments.budget_s, progress);
  TrainOptions options;
  REPRISE_ASSIGN(Bench bench, openBench(subject, workspace, benchOptions(arguments), device));
  bench.measuring.store = &bench.store;
  options.limits = arguments.demand.planning;
  options.budget = &budget;
  options.cpu_clock = device.is_cpu;
  REPRISE_ASSIGN(const Training training, train(subject, workspace, bench.measuring, options, progress));  // 5 rewrite .. 7 train
  clock.end("train");

  const FittedTraining fitted = fitTraining(subject, training, options.limits);              // 8 fit
  Selection selection;                                                                          // 9 select
  if (fitted.input.original_frame_ms > 0) {
    SelectionOptions selecting;
    selecting.threshold = options.limits.limit();
    selecting.least_speedup = arguments.least_gain;
    selecting.shorter_periods = true;
    result.threshold.margin = selecting.error_margin;
    REPRISE_ASSIGN(selection, select(fitted.input, selecting));
  }
  clock.end("fit and select");

  bench.measuring.supervisor.expired = [&] { return budget.isSpent(kValidationShare); };
  ValidationPlan judging;
  judging.limits = arguments.demand.binding;
  judging.least_gain = arguments.least_gain;
  judging.cpu_clock = device.is_cpu;
  REPRISE_ASSIGN(const Validated validated, validateInOrder(subject, workspace, bench.measuring, training, fitted, selection, judging, progress));
  clock.end("validate");                                                                        // 10 validate

  result.candidates = describeCandidates(subject, training, fitted, selection, options.limits);
  result.warnings = training.warnings;
  result.warnings.insert(result.warnings.end(), short_sessions.begin(), short_sessions.end());
  for (const std::string& warning : costWarnings(training)) result.warnings.push_back(warning);
  for (const ModelSpec& model : subject.scenario.models)
    for (const std::string& warning : model.scene->warnings) result.warnings.push_back("model '" + model.name + "': " + warning);
  result.not_reached = training.not_reached;
  if (validated.budget_ended) result.not_reached.push_back(fmt::format("the validation of {}", validated.attempts.empty() ? "any variant" : "further variants"));
  for (const auto& [strategy, why] : training.strategies_refused) result.strategies_refused.push_back(strategy + ": " + why);
  for (const ValidationAttempt& attempt : validated.attempts) result.attempts.push_back(describeAttempt(fitted, attempt));
  if (validated.accepted) describeAccepted(subject, training, fitted, validated.chosen(), result);
  if (!validated.attempts.empty()) {
    result.validation = describeSessions(validated.shown().run, arguments.demand.binding);
    result.metrics = describeMetrics(validated.shown().run);
  }
  describeOriginal(training, selection, validated, result);
  addWarnings(subject, selection, fitted, result);
  if (std::optional<std::string> suspect = suspectMotion(subject, training, result.choice.candidate_id))
    result.warnings.insert(result.warnings.begin(), std::move(*suspect));
  bench.measuring.supervisor.expired = [&] { return budget.isSpent(kPicturesShare); };
  REPRISE_ASSIGN(const RunEvidence evidence, gatherEvidence({subject, workspace, bench.measuring, training, fitted}, selection, validated, result));
  const std::optional<ChosenVariant> chosen = chosenVariant(subject, training, fitted, validated);
  REPRISE_ASSIGN(const Package package, shippedPackage(subject, chosen ? &*chosen : nullptr));
  REPRISE_TRY(writePackage(package, workspace.packageDir()));                                   // 6 emit
  REPRISE_TRY(writeChoice(workspace, subject, chosen ? &*chosen : nullptr, result));
  result.finished_at = utcNow();
  clock.end("emit and report");
  REPRISE_TRY(writeFile(workspace.root() / "result.json", resultToJson(result)));
  REPRISE_TRY(writeFile(workspace.root() / "evidence.json", evidenceToJson(evidence)));
  REPRISE_TRY(reportAgain(workspace.root().string()));                                          // 11 report
  return result;
}

Result<RunResult> validateAgain(const std::string& directory, const OptimizeArguments& arguments, Progress& progress) {
  const std::filesystem::path root = directory;
  REPRISE_ASSIGN(const std::string text, readFile(root / "result.json"));
  REPRISE_ASSIGN(RunResult result, resultFromJson(text));
  REPRISE_ASSIGN(const Package package, readPackage(root / "package"));
  if (result.choice.kind != ChoiceKind::kVariant)
    return Error{ErrorKind::kInput, "validate.original",
                 "the answer of '" + directory + "' is " + (result.choice.kind == ChoiceKind::kOriginal ? "the original" : "undecided") + "; there is nothing to validate", {}};
  REPRISE_ASSIGN(Subject subject, readSubject(root / "scenario" / "scenario.toml"));
  REPRISE_ASSIGN(const MeasuredDevice measured, openMeasuredDevice(arguments.device));
  const DeviceSummary& device = measured.summary;
  limitTo(measured, subject);
  REPRISE_ASSIGN(const Workspace workspace, Workspace::open(directory));
  REPRISE_ASSIGN(const DeviceLock lock, lockDevice(device, arguments, progress));
  REPRISE_ASSIGN(Bench bench, openBench(subject, workspace, benchOptions(arguments), device));
  bench.measuring.store = &bench.store;
  ValidationPlan plan;
  const auto candidate = std::find_if(subject.candidates.begin(), subject.candidates.end(),
                                      [&](const Candidate& one) { return one.id == result.choice.candidate_id; });
  if (candidate == subject.candidates.end())
    return Error{ErrorKind::kInput, "validate.payload", "the payload '" + result.choice.candidate_id + "' is not in the shader of '" + directory + "'", {}};
  plan.candidate = static_cast<std::size_t>(candidate - subject.candidates.begin());
  const Recipe& recipe = package.variant;
  plan.options = baseOptions(subject, rangesOf(recipe));
  plan.options.strategy = recipe.strategy;
  plan.options.pattern = recipe.pattern;
  plan.options.block_pixels = recipe.block_pixels;
  plan.options.filter = recipe.filter;
  plan.options.encoding = recipe.encoding;
  plan.options.period_frames = recipe.period_frames;
  plan.packages = {(root / "package").string()};
  plan.limits = limitsOf(result);
  plan.least_gain = result.least_gain;
  plan.cpu_clock = device.is_cpu;
  REPRISE_ASSIGN(const ValidationRun run, validateChoice(subject, workspace, bench.measuring, plan, progress));
  result.device = describeDevice(measured, processorName());
  result.choice.measured_error = run.measured_error;
  result.choice.worst_frame_error = run.worst_frame_error;
  result.choice.measured_speedup = run.binding.ratio;
  result.choice.speedup_ci95 = RunInterval{run.binding.lo, run.binding.hi};
  result.choice.reason = run.judgement.reason;
  result.validation = describeSessions(run, plan.limits);
  result.metrics = describeMetrics(run);
  if (!run.judgement.accepted) return Error{ErrorKind::kInput, run.judgement.code, run.judgement.reason, {}};
  return result;
}

Result<CommittedCheck> validateCommitted(const CommittedArguments& committed, const OptimizeArguments& arguments, Progress& progress) {
  REPRISE_ASSIGN(const Choice choice, readChoice(committed.choice));
  if (choice.is_original)
    return Error{ErrorKind::kInput, "validate.original", "the choice of '" + committed.choice + "' is the original; there is nothing to validate", {}};
  REPRISE_ASSIGN(Subject subject, readSubjectUnranked(committed.scenario));
  REPRISE_ASSIGN(const ChosenVariant variant, variantOf(subject, choice));
  subject.candidates = {variant.candidate};
  REPRISE_ASSIGN(const MeasuredDevice measured, openMeasuredDevice(arguments.device));
  const DeviceSummary& device = measured.summary;
  limitTo(measured, subject);
  REPRISE_ASSIGN(const Workspace workspace, Workspace::open(arguments.output));
  REPRISE_TRY(copyInputs(subject, workspace.scenarioFile()));
  REPRISE_ASSIGN(const DeviceLock lock, lockDevice(device, arguments, progress));
  REPRISE_ASSIGN(Bench bench, openBench(subject, workspace, benchOptions(arguments), device));
  bench.measuring.store = &bench.store;
  ValidationPlan plan;
  plan.options = variant.options;
  plan.limits = choice.limits;
  plan.least_gain = choice.least_gain;
  plan.cpu_clock = device.is_cpu;
  ValidationRun run;
  const auto measure = [&](int timing) -> Result<CommittedMeasures> {
    if (timing > 1) {
      REPRISE_TRY(timeAgain(subject, workspace, bench.measuring, plan, progress, run));
    } else {
      REPRISE_ASSIGN(run, validateChoice(subject, workspace, bench.measuring, plan, progress));
    }
    return CommittedMeasures{run.judgement, run.worst_session_error, run.binding.ratio, device.name};
  };
  return checkCommittedAgain(choice, measure, committed.cost_tolerance);
}

}  // namespace reprise
