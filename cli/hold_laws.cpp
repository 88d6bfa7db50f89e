#include "cli/hold_laws.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/check/interpreted_bodies.h"
#include "cli/check/judgement.h"
#include "compiler/ir/reproducible.h"
#include "compiler/strategies/registry.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

constexpr std::uint32_t kFrozenPeriod = 4;
// A regrouped sum feeds the cache and is off by some units in the last place, times what the tail makes of it.
constexpr double kRegroupedTolerance = 2e-3;

bool keepsAllBits(const Recipe& recipe) {
  const Strategy* strategy = findStrategy(recipe.strategy);
  return strategy == nullptr || !strategy->keeps_raw_payload || recipe.encoding == Encoding::kRgba32f;
}

// With counters, so that hits can be told from misses; without where these need more colour targets than there are.
Result<StoredVariant> storeLawCopy(const Subject& subject, const Workspace& workspace, const VariantToHold& variant) {
  VariantOptions options = variant.options;
  options.encoding = Encoding::kRgba32f;
  options.filter = Filter::kNearest;
  options.instrumented = true;
  Result<StoredVariant> stored = storeVariant(workspace, subject.program, variant.candidate, options, subject.limits);
  if (stored.ok() || stored.error().code != "state.targets") return stored;
  options.instrumented = false;
  return storeVariant(workspace, subject.program, variant.candidate, options, subject.limits);
}

// The same package with NoContraction in all of its modules.
Result<std::string> storeStrict(const Workspace& workspace, const std::string& package_dir) {
  REPRISE_ASSIGN(Package package, readPackage(package_dir));
  for (auto& [name, words] : package.modules) {
    REPRISE_ASSIGN(const Module module, readModule(words));
    words = writeModule(withoutContraction(module));
    for (Recipe* recipe : {&package.original, &package.variant})
      for (ModuleEntry& entry : recipe->modules)
        if (entry.name == name) entry.hash = contentHash(bytesOf(words));
  }
  const std::string hash = contentHash(recipeToJson(package.original) + recipeToJson(package.variant));
  const std::string directory = (workspace.root() / "work" / "variants" / hash).string();
  REPRISE_TRY(writePackageFiles(package, directory));
  return directory;
}

std::string passOf(const std::string& strategy, int kind) {
  const Strategy* found = findStrategy(strategy);
  if (found == nullptr || kind <= 0) return kind == 0 ? ", where nothing is drawn" : "";
  for (const PassPlan& pass : found->passes)
    if (pass.counts && (kind == 1 ? pass.bodies.hit : pass.bodies.miss)) return fmt::format(", a {} of pass '{}'", kind == 1 ? "hit" : "miss", pass.name);
  return "";
}

std::string colorText(const std::array<std::uint32_t, 4>& words) {
  std::string text;
  for (const std::uint32_t word : words) text += fmt::format("{}{}", text.empty() ? "" : ", ", std::bit_cast<float>(word));
  return "(" + text + ")";
}

std::string textOf(const Evidence& evidence) {
  const char* interpreter = evidence.interpreted == Computation::kSame        ? "finds the same computation, so that the device enlarges what it rounds"
                            : evidence.interpreted == Computation::kDifferent ? "finds another computation"
                                                                              : "cannot say";
  return fmt::format("{} with NoContraction on both sides; the interpreter {}", evidence.equal_without_contraction ? "gone" : "there also", interpreter);
}

FailureRow convictionOf(const LawDifference& difference, const std::string& session, const std::string& strategy) {
  const bool frozen = difference.law == kFrozenWorld;
  return {difference.law,
          fmt::format("{} it differs from the original: {}, session '{}', frame {}, pixel ({}, {}) of output {}{}: expected {}, found {}; so do {} pixels of that image",
                      frozen ? "with the scene frozen" : "at its exact setting (period 1)", strategy, session, difference.frame, difference.x, difference.y,
                      difference.output, passOf(strategy, difference.kind), colorText(difference.expected), colorText(difference.found), difference.pixels)};
}

std::vector<std::string> sessionsOf(const Scenario& scenario, HeldSessions held) {
  std::vector<std::string> names;
  for (const SessionSpec& session : scenario.sessions)
    if (held == HeldSessions::kAll || session.role == SessionRole::kTraining) names.push_back(session.name);
  return names;
}

std::string verdictText(const LawVerdict& verdict) {
  nlohmann::json json = {{"frozen_hits", verdict.frozen_hits}, {"conviction", nullptr}};
  if (verdict.conviction) json["conviction"] = {{"code", verdict.conviction->code}, {"message", verdict.conviction->message}};
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::optional<LawVerdict> verdictFrom(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("frozen_hits") || !json.contains("conviction")) return std::nullopt;
  LawVerdict verdict;
  verdict.frozen_hits = json["frozen_hits"].get<std::uint64_t>();
  const nlohmann::json& conviction = json["conviction"];
  if (!conviction.is_null()) verdict.conviction = FailureRow{conviction.at("code").get<std::string>(), conviction.at("message").get<std::string>()};
  return verdict;
}

// One package of a variant.
struct Case {
  std::size_t variant = 0;  // index
  LawRequest request;
  std::string key;          // of its verdict in the store
  LawVerdict verdict;
  bool open = true;         // nothing is known yet
  // What may be rounding, and how far it is off: it convicts unless witnesses say that the computation is the same.
  std::optional<FailureRow> doubt;
  Evidence evidence;

  void convict(const FailureRow& why) {
    if (!verdict.conviction) verdict.conviction = why;
  }
};

class Court {
 public:
  Court(const Subject& subject, const Workspace& workspace, const Measuring& measuring, const std::vector<VariantToHold>& variants,
        std::vector<std::string> sessions)
      : subject_(subject), workspace_(workspace), measuring_(measuring), variants_(variants), sessions_(std::move(sessions)) {}

  Result<std::vector<LawVerdict>> hold(Progress& progress) {
    verdicts_.resize(variants_.size());
    for (std::size_t variant = 0; variant < variants_.size(); ++variant) REPRISE_TRY(prepare(variant));
    const auto open = std::count_if(cases_.begin(), cases_.end(), [](const Case& one) { return one.open; });
    if (open > 0) progress.begin(fmt::format("compare with the original: {}", open));
    REPRISE_TRY(compare());
    REPRISE_TRY(callWitnesses());
    for (Case& one : cases_) {
      // What hung on a busy machine gets another chance in the next run.
      const bool lasts = !one.verdict.conviction || isLawBroken(*one.verdict.conviction);
      if (one.open && lasts) REPRISE_TRY(measuring_.store->putText(one.key, verdictText(one.verdict)));
      LawVerdict& verdict = verdicts_[one.variant];
      verdict.frozen_hits += one.verdict.frozen_hits;
      if (!verdict.conviction) verdict.conviction = one.verdict.conviction;
    }
    return std::move(verdicts_);
  }

 private:
  Result<void> prepare(std::size_t index) {
    const VariantToHold& variant = variants_[index];
    const double tolerance = isRegrouped(variant.candidate) ? kRegroupedTolerance : 0;
    const Result<StoredVariant> copy = storeLawCopy(subject_, workspace_, variant);
    if (!copy.ok()) {
      if (copy.error().kind != ErrorKind::kRefused) return copy.error();
      LawVerdict& verdict = verdicts_[index];
      verdict.refused = !storeVariant(workspace_, subject_.program, variant.candidate, variant.options, subject_.limits).ok();
      if (!verdict.refused) verdict.conviction = FailureRow{copy.error().code, "it cannot be compared with the original: " + copy.error().message};
      return {};
    }
    const std::uint32_t period = variant.options.previous == PreviousImage::kOtherEye ? 2 : kFrozenPeriod;
    REPRISE_TRY(addCase({index, {copy->dir, period, tolerance}, copy->hash, {}}));
    for (const std::string& directory : variant.packages) {
      REPRISE_ASSIGN(const Package package, readPackage(directory));
      if (keepsAllBits(package.variant)) REPRISE_TRY(addCase({index, {directory, 1, tolerance}, contentHash(recipeToJson(package.variant)), {}}));
    }
    return {};
  }

  // one.key: the package's hash so far.
  Result<void> addCase(Case one) {
    const SeriesKey& base = measuring_.base;
    one.key = "laws 1 and 3 " + contentHash(fmt::format("{} {} {} {} {} {} {} {} {} {} {} {}", fmt::join(sessions_, ","), one.key, one.request.period_frames, one.request.tolerance, base.shader_hash,
                                                       base.scenario_hash, base.device, base.driver, base.width, base.height, base.seed, base.tool_version));
    REPRISE_ASSIGN(const std::optional<std::string> known, measuring_.store->text(one.key));
    if (known) {
      if (const std::optional<LawVerdict> verdict = verdictFrom(*known)) {
        one.verdict = *verdict;
        one.open = false;
      }
    }
    cases_.push_back(std::move(one));
    return {};
  }

  const std::string& strategyOf(const Case& one) const { return variants_[one.variant].options.strategy; }

  // What packages show that nobody has looked at, which convicts those that differ.
  Result<void> compare() {
    std::vector<LawRequest> requests;
    std::vector<Case*> asked;
    for (Case& one : cases_) {
      if (!one.open) continue;
      requests.push_back(one.request);
      asked.push_back(&one);
    }
    if (requests.empty()) return {};
    REPRISE_ASSIGN(const std::vector<LawFinding> findings, compareWithOriginal(measuring_, sessions_, requests, scratch()));
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const LawOutcome& outcome = findings[i].outcome;
      asked[i]->verdict.frozen_hits = outcome.frozen_hits;
      if (findings[i].failure) asked[i]->convict(*findings[i].failure);
      const bool rounded = outcome.rounding && outcome.rounding->visible;
      if (asked[i]->verdict.conviction || (!outcome.difference && !rounded)) continue;
      const LawDifference& difference = outcome.difference ? *outcome.difference : *outcome.rounding;
      asked[i]->doubt = convictionOf(difference, findings[i].session, strategyOf(*asked[i]));
      asked[i]->evidence.as_given = outcome.difference ? Nearness::kBeyond : Nearness::kRounded;
    }
    return {};
  }

  // The interpreter, of the bodies that a variant is made from; at most once for each variant.
  Computation interpret(std::size_t variant) {
    const auto [known, is_new] = interpreted_.try_emplace(variant, Computation::kUnknown);
    if (is_new)
      known->second = interpretBodies(subject_.program.fragment_words, *subject_.program.fragment, variants_[variant].candidate).computation;
    return known->second;
  }

  // Where bits differ: the interpreter first, which needs no device, then the same with NoContraction on both sides. What only the two
  // together excuse is a shader that enlarges rounding errors itself (judgement.h).
  Result<void> callWitnesses() {
    std::vector<LawRequest> requests;
    std::vector<Case*> asked;
    for (Case& one : cases_) {
      if (!one.doubt) continue;
      one.evidence.interpreted = interpret(one.variant);
      if (judge(one.evidence) != RoundingJudgement::kOurs) continue;
      asked.push_back(&one);
      requests.push_back(one.request);
      REPRISE_ASSIGN(requests.back().package_dir, storeStrict(workspace_, one.request.package_dir));
    }
    if (requests.empty()) return {};
    Measuring strict = measuring_;
    REPRISE_ASSIGN(strict.original_dir, storeStrict(workspace_, measuring_.original_dir));
    REPRISE_ASSIGN(const std::vector<LawFinding> findings, compareWithOriginal(strict, sessions_, requests, scratch()));
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const LawOutcome& outcome = findings[i].outcome;
      if (findings[i].failure) asked[i]->convict(*findings[i].failure);
      asked[i]->evidence.equal_without_contraction = !outcome.difference && !(outcome.rounding && outcome.rounding->visible);
      if (judge(asked[i]->evidence) != RoundingJudgement::kOurs) continue;
      FailureRow why = *asked[i]->doubt;
      why.message += " (" + textOf(asked[i]->evidence) + ")";
      asked[i]->convict(why);
    }
    return {};
  }

  std::string scratch() const { return (workspace_.root() / "work" / "reference").string(); }

  const Subject& subject_;
  const Workspace& workspace_;
  const Measuring& measuring_;
  const std::vector<VariantToHold>& variants_;
  std::vector<std::string> sessions_;
  std::vector<Case> cases_;
  std::vector<LawVerdict> verdicts_;
  std::map<std::size_t, Computation> interpreted_;  // by variant
};

}  // namespace

bool isLawBroken(const FailureRow& conviction) { return conviction.code == kExactSetting || conviction.code == kFrozenWorld; }

Result<std::vector<LawVerdict>> holdLaws(const Subject& subject, const Workspace& workspace, const Measuring& measuring,
                                         const std::vector<VariantToHold>& variants, Progress& progress, HeldSessions sessions) {
  return Court(subject, workspace, measuring, variants, sessionsOf(subject.scenario, sessions)).hold(progress);
}

}  // namespace reprise
