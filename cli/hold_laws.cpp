#include "cli/hold_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

#include "compiler/ir/reproducible.h"
#include "compiler/strategies/registry.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kFrozenPeriod = 4;
// A regrouped sum feeds the cache and is off by some units in the last place, times what the tail makes of it.
constexpr double kRegroupedTolerance = 2e-3;

bool keepsAllBits(const Recipe& recipe) {
  const Strategy* strategy = findStrategy(recipe.strategy);
  return strategy == nullptr || !strategy->keeps_raw_payload || recipe.encoding == Encoding::kRgba32f;
}

// With counters, so that hits can be told from misses; without where these need more colour targets than there are.
Result<StoredVariant> storeLawCopy(const Subject& subject, const Workspace& workspace, const HeldVariant& variant) {
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

FailureRow convictionOf(const LawDifference& difference, const std::string& session, const std::string& strategy) {
  const bool frozen = difference.law == kFrozenWorld;
  return {difference.law,
          fmt::format("{} it differs from the original: {}, session '{}', frame {}, pixel ({}, {}) of output {}{}: expected {}, found {}; so do {} pixels of that image",
                      frozen ? "with the scene frozen" : "at its exact setting (period 1)", strategy, session, difference.frame, difference.x, difference.y,
                      difference.output, passOf(strategy, difference.kind), colorText(difference.expected), colorText(difference.found), difference.pixels)};
}

std::vector<std::string> sessionsOf(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const SessionSpec& session : scenario.sessions) names.push_back(session.name);
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

// What is to be played for one variant.
struct Case {
  std::vector<LawRequest> requests;
  std::string key;  // of its verdict in the store
  LawVerdict verdict;
  bool open = true;
};

class Court {
 public:
  Court(const Subject& subject, const Workspace& workspace, const Measuring& measuring)
      : subject_(subject), workspace_(workspace), measuring_(measuring), sessions_(sessionsOf(subject.scenario)) {}

  Result<std::vector<LawVerdict>> hold(const std::vector<HeldVariant>& variants, Progress& progress) {
    std::vector<Case> cases;
    for (const HeldVariant& variant : variants) {
      REPRISE_ASSIGN(Case one, prepare(variant));
      cases.push_back(std::move(one));
    }
    const auto open = std::count_if(cases.begin(), cases.end(), [](const Case& one) { return one.open; });
    if (open > 0) progress.begin(fmt::format("compare with the original: {}", open));
    REPRISE_TRY(compare(measuring_, variants, cases));
    REPRISE_TRY(callWitness(variants, cases));
    std::vector<LawVerdict> verdicts;
    for (Case& one : cases) {
      if (!one.key.empty()) REPRISE_TRY(measuring_.store->putText(one.key, verdictText(one.verdict)));
      verdicts.push_back(std::move(one.verdict));
    }
    return verdicts;
  }

 private:
  Result<Case> prepare(const HeldVariant& variant) {
    Case one;
    const double tolerance = isRegrouped(variant.candidate) ? kRegroupedTolerance : 0;
    const Result<StoredVariant> copy = storeLawCopy(subject_, workspace_, variant);
    if (!copy.ok()) {
      if (copy.error().kind != ErrorKind::kRefused) return copy.error();
      one.open = false;
      one.verdict.refused = !storeVariant(workspace_, subject_.program, variant.candidate, variant.options, subject_.limits).ok();
      if (!one.verdict.refused) one.verdict.conviction = FailureRow{copy.error().code, "it cannot be compared with the original: " + copy.error().message};
      return one;
    }
    one.requests.push_back({copy->dir, variant.options.previous == PreviousImage::kOtherEye ? 2 : kFrozenPeriod, tolerance});
    std::string hashes = copy->hash;
    for (const std::string& directory : variant.packages) {
      REPRISE_ASSIGN(const Package package, readPackage(directory));
      if (!keepsAllBits(package.variant)) continue;
      one.requests.push_back({directory, 1, tolerance});
      hashes += " " + contentHash(recipeToJson(package.variant));
    }
    const SeriesKey& base = measuring_.base;
    one.key = "laws 1 and 3 " + contentHash(fmt::format("{} {} {} {} {} {} {} {} {} {}", hashes, base.shader_hash, base.scenario_hash, base.device, base.driver,
                                                       base.width, base.height, base.seed, base.tool_version, tolerance));
    REPRISE_ASSIGN(const std::optional<std::string> known, measuring_.store->text(one.key));
    const std::optional<LawVerdict> verdict = known ? verdictFrom(*known) : std::nullopt;
    if (verdict) {
      one.verdict = *verdict;
      one.open = false;
    }
    return one;
  }

  struct Place {
    std::size_t variant, request;
  };

  // What the packages of open cases show, which ends those that differ. Those that may be rounding are left in doubtful_.
  Result<void> compare(const Measuring& measuring, const std::vector<HeldVariant>& variants, std::vector<Case>& cases) {
    std::vector<LawRequest> requests;
    std::vector<Place> places;
    for (std::size_t i = 0; i < cases.size(); ++i)
      for (std::size_t request = 0; cases[i].open && request < cases[i].requests.size(); ++request) {
        requests.push_back(cases[i].requests[request]);
        places.push_back({i, request});
      }
    if (requests.empty()) return {};
    REPRISE_ASSIGN(const std::vector<LawFinding> findings, compareWithOriginal(measuring, sessions_, requests, scratch()));
    for (std::size_t i = 0; i < findings.size(); ++i) {
      Case& one = cases[places[i].variant];
      const LawFinding& finding = findings[i];
      one.verdict.frozen_hits += finding.outcome.frozen_hits;
      if (finding.failure) {
        end(one, *finding.failure);
      } else if (finding.outcome.difference) {
        end(one, convictionOf(*finding.outcome.difference, finding.session, variants[places[i].variant].options.strategy));
      } else if (finding.outcome.rounding && finding.outcome.rounding->visible) {
        doubtful_.push_back(places[i]);
      }
    }
    for (Case& one : cases) one.open = false;
    return {};
  }

  static void end(Case& one, const FailureRow& conviction) {
    if (!one.verdict.conviction) one.verdict.conviction = conviction;
  }

  // Where the bits differ by what may be rounding: they must not where neither side is free to round as it likes.
  Result<void> callWitness(const std::vector<HeldVariant>& variants, std::vector<Case>& cases) {
    std::vector<LawRequest> requests;
    for (const Place& place : doubtful_) {
      LawRequest strict = cases[place.variant].requests[place.request];
      REPRISE_ASSIGN(strict.package_dir, storeStrict(workspace_, strict.package_dir));
      requests.push_back(strict);
    }
    if (requests.empty()) return {};
    Measuring strict = measuring_;
    REPRISE_ASSIGN(strict.original_dir, storeStrict(workspace_, measuring_.original_dir));
    REPRISE_ASSIGN(const std::vector<LawFinding> findings, compareWithOriginal(strict, sessions_, requests, scratch()));
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const LawFinding& finding = findings[i];
      const LawOutcome& outcome = finding.outcome;
      const std::optional<LawDifference>& differs = outcome.difference || !outcome.rounding || !outcome.rounding->visible ? outcome.difference : outcome.rounding;
      Case& one = cases[doubtful_[i].variant];
      if (finding.failure) {
        end(one, *finding.failure);
      } else if (differs) {
        FailureRow conviction = convictionOf(*differs, finding.session, variants[doubtful_[i].variant].options.strategy);
        conviction.message += " (with NoContraction on both sides, so it is no rounding)";
        end(one, conviction);
      }
    }
    return {};
  }

  std::string scratch() const { return (workspace_.root() / "work" / "reference").string(); }

  const Subject& subject_;
  const Workspace& workspace_;
  const Measuring& measuring_;
  std::vector<std::string> sessions_;
  std::vector<Place> doubtful_;
};

}  // namespace

Result<std::vector<LawVerdict>> holdLaws(const Subject& subject, const Workspace& workspace, const Measuring& measuring,
                                         const std::vector<HeldVariant>& variants, Progress& progress) {
  return Court(subject, workspace, measuring).hold(variants, progress);
}

}  // namespace reprise
