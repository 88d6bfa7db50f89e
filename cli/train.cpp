#include "cli/train.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>

#include "cli/fit.h"
#include "cli/probe_candidates.h"
#include "cli/probe_objects.h"
#include "cli/session_pace.h"
#include "cli/studied_periods.h"
#include "cli/training_laws.h"
#include "compiler/strategies/refuse_variant.h"

namespace reprise {
namespace {

std::vector<std::string> trainingSessions(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const SessionSpec& session : scenario.sessions)
    if (session.role == SessionRole::kTraining) names.push_back(session.name);
  return names;
}

constexpr double kErrorShare = 0.3;  // of the budget: beyond it only the errors of what will be timed are measured

class Trainer {
 public:
  Trainer(const Subject& subject, const Workspace& workspace, const Measuring& measuring, const TrainOptions& options, Progress& progress)
      : subject_(subject), workspace_(workspace), measuring_(measuring), options_(options), progress_(progress),
        sessions_(trainingSessions(subject.scenario)), periods_(studiedPeriods(subject.scenario)) {
    measuring_.progress = [this](const JobProgress& state) { progress_.update(state.done, state.total); };
    measuring_.supervisor.expired = [this] { return isSpent(1); };
  }

  Result<Training> run() {
    const Result<void> done = steps();
    if (done.ok()) return std::move(training_);
    if (done.error().code != kBudgetEnded) return done.error();
    endBudget(step_);
    return std::move(training_);
  }

 private:
  Result<void> steps() {
    step_ = "the ranges of the candidates were known";
    REPRISE_ASSIGN(ProbedRanges probed, probeCandidates(subject_, workspace_, measuring_, progress_));
    training_.ranges = std::move(probed.ranges);
    training_.changes = std::move(probed.changes);
    training_.failed = std::move(probed.failed);
    training_.warnings = std::move(probed.warnings);
    for (const auto& [candidate, ranges] : training_.ranges) addStudy(candidate, baseOptions(subject_, ranges, subject_.candidates[candidate]));
    if (!training_.errors.empty()) {
      const ErrorStudy& first = training_.errors.front();
      REPRISE_ASSIGN(training_.strategies_refused, strategiesWithoutIdleObjects(subject_, workspace_, measuring_, {first.candidate, first.options.ranges}, progress_));
    }
    REPRISE_TRY(study(0, periods_, [this] { return worthTiming(); }));
    return refine();
  }

  // Whether a share of training's part of the budget is.
  bool isSpent(double share) const {
    const bool timed = std::any_of(training_.costs.begin(), training_.costs.end(), [](const CostStudy& costs) { return !costs.frames.empty(); });
    return options_.budget != nullptr && options_.budget->isSpent(share * (timed ? kTrainingShare : kFirstTimesShare));
  }

  void endBudget(const std::string& what) {
    training_.not_reached.push_back(what);
    training_.budget_ended = true;
  }

  // Before a step; else remembers what is under way.
  bool outOfBudget(const std::string& what) {
    step_ = what;
    if (!isSpent(1)) return false;
    endBudget(what);
    return true;
  }

  void addStudy(std::size_t candidate, const VariantOptions& options) {
    VariantOptions instrumented = options;
    instrumented.instrumented = instrumented.aged = true;
    // Errors are the same in every strategy (law 11); where state and device allow it, two passes render fastest on CPU devices.
    instrumented.strategy = "two_pass";
    if (refuseVariant(subject_.program, subject_.candidates[candidate], instrumented, subject_.limits)) instrumented.strategy = "branch";
    training_.errors.push_back({candidate, instrumented, {}, ""});
  }

  struct ErrorPlan {
    std::vector<SeriesRequest> requests;
    std::vector<std::pair<std::size_t, std::uint32_t>> places;  // study and period of each
  };

  // Session by session the errors of all studies from `first` on, then the frame times of those that `chosen` names once the first
  // session's errors are known: a budget that ends early leaves whole sessions, of which each can be fitted. Studies beyond as many as are
  // timed are left out of all sessions where the others' errors in the first one took a good part of the budget.
  Result<void> study(std::size_t first, const std::vector<std::uint32_t>& periods, const std::function<std::vector<StudyAndStrategy>()>& chosen) {
    const std::size_t studies = training_.errors.size(), leading = first > 0 ? studies : std::min(studies, options_.timed_candidates);
    REPRISE_ASSIGN(ErrorPlan errors, planErrors(first, leading, periods));
    REPRISE_ASSIGN(ErrorPlan others, planErrors(leading, studies, periods));
    std::optional<TimePlan> times;
    for (const std::string& session : sessions_) {
      REPRISE_TRY(measureErrorsOf(session, errors));
      if (!times && isSpent(kErrorShare) && !others.requests.empty()) {
        endBudget(fmt::format("errors of {} further variants", others.requests.size()));
        others = {};
      }
      REPRISE_TRY(measureErrorsOf(session, others));
      if (!times) {
        REPRISE_ASSIGN(times, planTimes(chosen()));
        if (first > 0 && times->variants == 0) return {};
      }
      REPRISE_TRY(timeSession(session, *times));
    }
    return {};
  }

  Result<ErrorPlan> planErrors(std::size_t first, std::size_t end, const std::vector<std::uint32_t>& periods) {
    ErrorPlan plan;
    for (std::size_t study = first; study < end; ++study) {
      ErrorStudy& errors = training_.errors[study];
      const Result<StoredVariant> variant =
          storeVariant(workspace_, subject_.program, subject_.candidates[errors.candidate], errors.options, subject_.limits);
      if (!variant.ok()) {
        if (variant.error().kind != ErrorKind::kRefused) return variant.error();
        errors.failure = variant.error().message;
        continue;
      }
      for (const std::uint32_t period : periods) {
        plan.requests.push_back({variant->dir, variant->hash, period});
        plan.places.push_back({study, period});
      }
    }
    return plan;
  }

  // Takes out what differs from the original, or cannot be compared with it.
  Result<void> holdToLaws(ErrorPlan& plan) {
    std::set<std::size_t> studies;
    for (const auto& [study, period] : plan.places) studies.insert(study);
    REPRISE_ASSIGN(const std::set<std::size_t> convicted, laws_.holdErrors(studies, training_));
    ErrorPlan left;
    for (std::size_t i = 0; i < plan.requests.size(); ++i) {
      if (convicted.count(plan.places[i].first) > 0) continue;
      left.requests.push_back(plan.requests[i]);
      left.places.push_back(plan.places[i]);
    }
    plan = std::move(left);
    return {};
  }

  Result<void> measureErrorsOf(const std::string& session, ErrorPlan& plan) {
    if (plan.requests.empty() || outOfBudget(fmt::format("errors of {} variants in session '{}'", plan.requests.size(), session))) return {};
    REPRISE_TRY(holdToLaws(plan));
    if (plan.requests.empty()) return {};
    progress_.begin(fmt::format("errors: {} x {}", session, plan.requests.size()));
    REPRISE_ASSIGN(std::vector<ErrorSeries> series, measureErrors(measuring_, session, plan.requests, 0));
    for (std::size_t i = 0; i < series.size(); ++i) {
      ErrorStudy& errors = training_.errors[plan.places[i].first];
      if (series[i].failure) {
        errors.failure = series[i].failure->message;
      } else {
        errors.rows[plan.places[i].second][session] = std::move(series[i].rows);
      }
    }
    return {};
  }

  // The longest trained period whose predicted error stays under the threshold; 0 if even 2 does not.
  std::uint32_t longestPeriod(const ErrorStudy& study) const {
    const ErrorFit fit = fitErrors(study, options_.limits);
    if (!isUsable(fit.verdict)) return 0;
    std::uint32_t longest = 0;
    for (const std::uint32_t period : periods_)
      if (period != kNeverRefresh && predictError(fit, period).value <= options_.limits.limit()) longest = std::max(longest, period);
    return longest;
  }

  bool acceptsNever(const ErrorStudy& study) const {
    const std::optional<double> never = neverError(study, options_.limits);
    return never && *never <= options_.limits.limit();
  }

  bool isAcceptable(const ErrorStudy& study) const { return !study.rows.empty() && (longestPeriod(study) >= 2 || acceptsNever(study)); }

  // Hits are told from misses by two hit rates: the shortest period, and the longest that the errors allow. Only periods whose hits
  // were counted will do.
  std::vector<std::uint32_t> timedPeriods(const ErrorStudy& study) const {
    std::uint32_t shortest = kNeverRefresh;
    for (const auto& [period, rows] : study.rows)
      if (period > 1 && (shortest == kNeverRefresh || period < shortest)) shortest = period;
    const std::uint32_t longest = acceptsNever(study) ? kNeverRefresh : std::max(shortest, longestPeriod(study));
    return longest == shortest ? std::vector{shortest} : std::vector{shortest, longest};
  }

  // None: the original's time is wanted also where no candidate is worth timing.
  std::vector<StudyAndStrategy> worthTiming() {
    std::vector<StudyAndStrategy> wanted;
    std::size_t timed = 0;
    for (std::size_t study = 0; study < training_.errors.size(); ++study) {
      if (!isAcceptable(training_.errors[study])) continue;
      if (timed == options_.timed_candidates) {
        training_.not_reached.push_back("frame times of " + subject_.candidates[training_.errors[study].candidate].id + " (fewer candidates are timed than have an acceptable error)");
        continue;
      }
      ++timed;
      for (const Strategy& strategy : strategies())
        if (strategy.selectable && training_.strategies_refused.count(strategy.name) == 0) wanted.push_back({study, strategy.name});
    }
    return wanted;
  }

  struct TimedEntry {
    enum class Kind { kOriginal, kPrepass, kLimit, kVariant } kind = Kind::kVariant;
    std::size_t target = 0;  // candidate of a limit, index into Training::costs of a variant
    std::uint32_t period = 1;
  };

  struct TimePlan {
    std::vector<SeriesRequest> requests;
    std::vector<TimedEntry> entries;  // of each request
    std::size_t variants = 0;         // studies that were asked for
  };

  Result<void> addEntry(const VariantOptions& options, std::size_t candidate, const TimedEntry& entry, TimePlan& plan, std::string* failure) {
    const Candidate& payload = subject_.candidates.empty() ? Candidate{} : subject_.candidates[candidate];
    const Result<StoredVariant> variant = storeVariant(workspace_, subject_.program, payload, options, subject_.limits);
    if (!variant.ok()) {
      if (variant.error().kind != ErrorKind::kRefused) return variant.error();
      if (failure != nullptr) *failure = variant.error().message;
      return {};
    }
    plan.requests.push_back({variant->dir, variant->hash, entry.period});
    plan.entries.push_back(entry);
    return {};
  }

  Result<TimePlan> planTimes(const std::vector<StudyAndStrategy>& wanted) {
    TimePlan plan;
    plan.variants = wanted.size();
    VariantOptions reference = baseOptions(subject_, unprobedRanges(subject_));
    reference.strategy = "original";
    REPRISE_TRY(addEntry(reference, 0, {TimedEntry::Kind::kOriginal, 0, 1}, plan, nullptr));
    reference.strategy = "original_prepass";
    REPRISE_TRY(addEntry(reference, 0, {TimedEntry::Kind::kPrepass, 0, 1}, plan, nullptr));
    for (const auto& [study, strategy] : wanted) {
      const ErrorStudy& errors = training_.errors[study];
      VariantOptions options = errors.options;
      options.instrumented = false;
      if (training_.limits.emplace(errors.candidate, std::vector<TimedFrame>{}).second) {
        options.strategy = "tail_only";
        REPRISE_TRY(addEntry(options, errors.candidate, {TimedEntry::Kind::kLimit, errors.candidate, 1}, plan, nullptr));
      }
      options.strategy = strategy;
      training_.costs.push_back({study, strategy, {}, {}, ""});
      std::string& refusal = training_.costs.back().failure;
      for (const std::uint32_t period : timedPeriods(errors))
        REPRISE_TRY(addEntry(options, errors.candidate, {TimedEntry::Kind::kVariant, training_.costs.size() - 1, period}, plan, &refusal));
      if (!refusal.empty()) training_.strategies_refused.emplace(strategy, refusal);
    }
    return plan;
  }

  Result<void> timeSession(const std::string& session, const TimePlan& plan) {
    if (outOfBudget(fmt::format("frame times of {} variants in session '{}'", plan.requests.size(), session))) return {};
    progress_.begin(fmt::format("times: {} x {}", session, plan.requests.size()));
    REPRISE_ASSIGN(const std::vector<TimeSeries> series,
                   measureTimes(measuring_, {session, imagesOf(subject_.scenario, options_.rounds), false}, plan.requests));
    const std::vector<TimedFrame> reference = fasterReference(plan.entries, series);
    const auto [first, is_first] = first_reference_.emplace(session, reference);
    const SessionPace pace = is_first ? SessionPace{} : paceAgainst(first->second, reference);
    for (std::size_t i = 0; i < series.size(); ++i) {
      const TimedEntry& entry = plan.entries[i];
      const bool is_reference = entry.kind == TimedEntry::Kind::kOriginal || entry.kind == TimedEntry::Kind::kPrepass;
      if (is_reference && !is_first) continue;
      keepTimes(session, entry, series[i], pace);
      if (entry.kind == TimedEntry::Kind::kVariant) training_.costs[entry.target].reference[session] = atPace(reference, pace);
    }
    return {};
  }

  std::vector<TimedFrame> timedFrames(const TimeSeries& series) const {
    std::vector<TimedFrame> frames;
    for (const TimeRow& row : series.rows) frames.push_back({row.frame, options_.cpu_clock ? row.cpu_ms : row.gpu_ms, row.wall_ms});
    return frames;
  }

  std::vector<TimedFrame> fasterReference(const std::vector<TimedEntry>& entries, const std::vector<TimeSeries>& series) const {
    std::map<double, std::vector<TimedFrame>> by_median;
    for (std::size_t i = 0; i < series.size(); ++i) {
      if (entries[i].kind != TimedEntry::Kind::kOriginal && entries[i].kind != TimedEntry::Kind::kPrepass) continue;
      std::vector<double> times;
      for (const TimedFrame& frame : timedFrames(series[i])) times.push_back(frame.clock_ms);
      if (!times.empty()) by_median[medianOf(times)] = timedFrames(series[i]);
    }
    return by_median.empty() ? std::vector<TimedFrame>{} : by_median.begin()->second;
  }

  void keepTimes(const std::string& session, const TimedEntry& entry, const TimeSeries& series, const SessionPace& pace) {
    const std::vector<TimedFrame> frames = atPace(timedFrames(series), pace);
    const auto append = [&](std::vector<TimedFrame>& to) { to.insert(to.end(), frames.begin(), frames.end()); };
    switch (entry.kind) {
      case TimedEntry::Kind::kOriginal: append(training_.original); break;
      case TimedEntry::Kind::kPrepass: append(training_.prepass); break;
      case TimedEntry::Kind::kLimit: append(training_.limits[entry.target]); break;
      case TimedEntry::Kind::kVariant:
        if (series.failure) keepFailure(training_.costs[entry.target], series.failure->message);
        else training_.costs[entry.target].frames[entry.period][session] = frames;
        break;
    }
  }

  void keepFailure(CostStudy& costs, const std::string& message) {
    if (!costs.failure.empty()) return;
    costs.failure = message;
    training_.warnings.push_back(fmt::format("{} in {} could not be timed: {}", subject_.candidates[training_.errors[costs.error_study].candidate].id,
                                             costs.strategy, message));
  }

  Result<void> refine() {
    const FittedTraining fitted = fitTraining(subject_, training_, options_.limits);
    if (fitted.input.configurations.empty() || !(fitted.input.original_frame_ms > 0)) return {};
    SelectionOptions selecting;
    selecting.threshold = options_.limits.limit();
    REPRISE_ASSIGN(const Selection selection, select(fitted.input, selecting));
    if (selection.ranking.empty()) return {};
    const TradeoffPoint& best = selection.ranking.front();
    const CostStudy best_costs = training_.costs[fitted.cost_study[best.configuration]];
    const ErrorStudy base = training_.errors[best_costs.error_study];
    const std::size_t first = training_.errors.size();
    const auto alternative = [&](auto change) {
      VariantOptions options = base.options;
      change(options);
      addStudy(base.candidate, options);
    };
    // Integers have one way to be kept and fetched, that of the base options.
    if (!isInteger(subject_.candidates[base.candidate].scalar)) {
      alternative([](VariantOptions& options) { options.encoding = Encoding::kRgba8; });
      alternative([](VariantOptions& options) { options.encoding = Encoding::kRgba16; });
      alternative([](VariantOptions& options) { options.filter = Filter::kNearest; });
    }
    if (!subject_.scenario.stereo) {
      alternative([](VariantOptions& options) { options.pattern = PatternKind::kTiled; });
      alternative([](VariantOptions& options) { options.pattern = PatternKind::kRandom; });
    }
    return study(first, refinedPeriods(periods_, best.period_frames), [&] {
      std::vector<StudyAndStrategy> wanted;
      for (std::size_t study = first; study < training_.errors.size(); ++study)
        if (isAcceptable(training_.errors[study])) wanted.push_back({study, best_costs.strategy});
      return wanted;
    });
  }

  const Subject& subject_;
  const Workspace& workspace_;
  Measuring measuring_;
  const TrainOptions& options_;
  Progress& progress_;
  std::vector<std::string> sessions_;
  std::vector<std::uint32_t> periods_;
  std::map<std::string, std::vector<TimedFrame>> first_reference_;  // by session
  std::string step_;  // what is lost if the budget ends now
  TrainingLaws laws_{subject_, workspace_, measuring_, progress_};
  Training training_;
};

}  // namespace

VariantOptions baseOptions(const Subject& subject, const ValueRanges& ranges, const Candidate& candidate) {
  VariantOptions options;
  options.pattern = subject.scenario.stereo ? PatternKind::kWhole : PatternKind::kInterleaved;
  options.block_pixels = 16;
  options.filter = isInteger(candidate.scalar) ? Filter::kNearest : Filter::kBilinear;
  options.encoding = isInteger(candidate.scalar) ? Encoding::kRgba32f : Encoding::kRgba16f;
  options.orthographic = subject.orthographic;
  if (subject.scenario.stereo) {
    options.previous = PreviousImage::kOtherEye;
    options.period_frames = 2;
  }
  options.ranges = ranges;
  return options;
}

Result<Training> train(const Subject& subject, const Workspace& workspace, const Measuring& measuring, const TrainOptions& options,
                       Progress& progress) {
  return Trainer(subject, workspace, measuring, options, progress).run();
}

}  // namespace reprise
