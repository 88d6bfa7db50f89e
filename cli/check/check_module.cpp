#include "cli/check/check_module.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "cli/check/capabilities.h"
#include "cli/check/check_subject.h"
#include "cli/check/covering_integers.h"
#include "cli/check/divergent_quads.h"
#include "cli/check/endless_loops.h"
#include "cli/check/harness_program.h"
#include "cli/check/interpreted.h"
#include "cli/check/interpreted_bodies.h"
#include "cli/check/module_player.h"
#include "cli/check/neighbour_dependence.h"
#include "cli/check/undefined_values.h"
#include "compiler/ir/reproducible.h"
#include "compiler/source/validate.h"
#include "compiler/strategies/registry.h"

namespace reprise {
namespace {

constexpr int kSeedsTried = 5;
constexpr std::size_t kAssignmentsTried = 32;      // of integers, for one module
constexpr std::size_t kAssignmentsPerVariant = 4;  // a variant is played with one in so many
constexpr std::size_t kCandidatesTried = 4;  // with the first seed that means something; the best one alone with the others

// What stays the same for all looks at one module.
struct Bench {
  const CheckRequest& request;
  const CheckHooks& hooks;
  const Context& context;
  Commands& commands;
  const CompiledShader& vertex;
  const CompiledShader& given;
  Reference reference;
};

class ModuleCheck {
 public:
  explicit ModuleCheck(const Bench& bench) : bench_(bench) { verdict_.path = bench.request.path; }

  // `ours` is what is prepared and rewritten: the module as given.
  ModuleVerdict run(const CompiledShader& ours) {
    const Result<void> result = check(ours);
    if (!result.ok()) {
      const Error& error = result.error();
      if (error.code == "device.timeout") {
        end(Verdict::kHung, "variant.hung", "the original runs, but on the prepared module or a variant " + error.message);
      } else {
        end(error.kind == ErrorKind::kRefused ? Verdict::kRefused : Verdict::kUntestable, error.code, error.message);
      }
    }
    return verdict_;
  }

  // Of a failure: where it was, and whether its images alone make it one.
  const HarnessOptions& inputs() const { return inputs_; }
  bool is_excusable() const { return failed() && interpreted_.computation != Computation::kDifferent; }
  // Of a failed variant whose bodies compute what the module does: whether what the device draws of the module itself depends on which
  // pixels run beside one another.
  Result<bool> isDevicesFault() {
    if (failed_bodies_ != Computation::kSame) return false;
    REPRISE_ASSIGN(const Module module, readModule(bench_.given.words));
    REPRISE_ASSIGN(const Originals* originals, originals_->get(false));
    return dependsOnNeighbours(module, originals->given, [&](const std::vector<std::uint32_t>& words) { return player_->playWords(words); });
  }

 private:
  struct Unshown {
    std::string code, reason;
    HarnessOptions inputs;
    std::shared_ptr<OriginalFrames> originals;
    const Candidate* candidate = nullptr;
    bool inconsistent = false;
  };

  void end(Verdict verdict, const std::string& code, const std::string& reason) {
    verdict_.verdict = verdict;
    verdict_.seed = inputs_.seed;
    verdict_.code = code;
    verdict_.reason = reason;
  }

  bool failed() const { return verdict_.verdict == Verdict::kFailed; }

  Result<void> check(const CompiledShader& ours) {
    bench_.hooks.enters(CheckStage::kPrepare);
    REPRISE_ASSIGN(ShaderProgram program, harnessProgram(bench_.vertex, ours));
    if (const Result<void> valid = validateModule(preparedWords(program)); !valid.ok()) {
      end(Verdict::kFailed, "prepare", "the prepared module is not valid SPIR-V: " + valid.error().message);
      return {};
    }
    // Refused modules, too: it tells of what was prepared, not of what is made from that.
    interpreted_ = interpretPrepared(bench_.given.words, preparedWords(program));
    if (interpreted_.computation == Computation::kDifferent) {
      end(Verdict::kFailed, "prepare", "the reference interpreter finds that the prepared module computes something else " + interpreted_.text);
      return {};
    }
    if (program.analysis.refusal) return *program.analysis.refusal;
    if (program.interface.outputs.empty())
      return Error{ErrorKind::kRefused, "output.none", "the shader has no colour output that a payload could serve", {}};
    REPRISE_ASSIGN(candidates_, candidatesOf(program));
    may_show_undefined_ = mayShowUndefined(*program.fragment);
    const Reference reference = [this](const ReferenceAsk& ask) -> Result<std::vector<HarnessFrame>> {
      bench_.hooks.enters(CheckStage::kOriginal);
      auto answer = bench_.reference(ask);
      bench_.hooks.enters(CheckStage::kVariants);
      if (!answer.ok() && answer.error().code == "device.timeout")
        return Error{ErrorKind::kMachine, "original.hung", "on the module alone " + answer.error().message, {}};
      return answer;
    };
    REPRISE_ASSIGN(const StateLimits limits, limitsFor(program, bench_.context));
    player_ = std::make_unique<ModulePlayer>(bench_.context, bench_.commands, std::move(program), reference, limits);
    return tryInputs();
  }

  // Until the inputs show something; whatever ends the check is in the verdict then.
  Result<void> tryInputs() {
    for (int i = 0; i < kSeedsTried; ++i) {
      inputs_ = HarnessOptions{};
      inputs_.seed = bench_.request.seed + static_cast<std::uint32_t>(i);
      REPRISE_ASSIGN(const bool ended, tryOne(i));
      if (ended) return {};
    }
    return unshown_ ? concludeUnshown() : Result<void>{};
  }

  // True once the verdict stands.
  Result<bool> tryOne(int attempt) {
    REPRISE_TRY(useInputs());
    REPRISE_ASSIGN(const bool ended, holdUncached());
    if (ended) return true;
    REPRISE_ASSIGN(const Originals* originals, originals_->get(false));
    const Meaning meaning = meaningOf(originals->given[kFrozenShot], player_->program().interface.outputs, leftOutOf(kFrozenShot));
    if (meaning.shows == Showing::kNothing) {
      end(Verdict::kUntestable, "inputs.meaningless", fmt::format("with {} seeds from {}: {}", attempt + 1, bench_.request.seed, meaning.why));
      return false;
    }
    if (may_show_undefined_ && !looked_at_undefined_) {  // else only where something differs
      REPRISE_ASSIGN(const bool undefined, showsUndefined());
      if (undefined) return true;
    }
    if (meaning.shows == Showing::kConstant) {
      noteUnshown("image.constant", meaning.why, candidates_.front());
      return false;
    }
    const std::size_t most = shown_seeds_++ > 0 ? static_cast<std::size_t>(bench_.request.candidates)
                                                : std::max<std::size_t>(kCandidatesTried, static_cast<std::size_t>(bench_.request.candidates));
    int meaningful = 0;
    for (std::size_t c = 0; c < std::min(most, candidates_.size()) && meaningful < bench_.request.candidates; ++c) {
      ++verdict_.candidates;
      REPRISE_ASSIGN(const bool shows, holdCandidate(candidates_[c], true));
      if (failed()) return true;
      meaningful += shows ? 1 : 0;
    }
    if (meaningful == 0) return false;
    REPRISE_TRY(holdOtherIntegers());
    if (!failed()) conclude(Verdict::kVerified, "", "");
    return true;
  }

  // Integers that decide how often loops run and which way branches go take other values in turn: law 0 is held with each, and now and
  // then the laws of a variant. A module that does not survive them has been compared without.
  Result<void> holdOtherIntegers() {
    const std::vector<IntegerAssignment> assignments = coveringAssignments(player_->program(), kAssignmentsTried);
    for (std::size_t i = 0; i < assignments.size() && !failed(); ++i) {
      inputs_.integers = assignments[i];
      const Result<void> held = holdWith(i % kAssignmentsPerVariant == 0);
      if (!held.ok() && held.error().code.starts_with("original.")) return {};
      REPRISE_TRY(held);
    }
    return {};
  }

  Result<void> holdWith(bool variant) {
    REPRISE_TRY(useInputs());
    REPRISE_ASSIGN(const bool ended, holdUncached());
    if (ended || !variant) return {};
    const Result<VariantFrames> frames = holdStrategy(*shown_candidate_, shown_strategy_);
    return frames.ok() ? Result<void>{} : frames.error();
  }

  const std::vector<bool>* leftOutOf(std::size_t frame) const { return player_->leftOut().empty() ? nullptr : &player_->leftOut()[frame]; }

  Result<void> useInputs() {
    REPRISE_TRY(player_->setInputs(inputs_));
    originals_ = std::make_shared<OriginalFrames>([this](bool no_contraction) { return player_->originals(no_contraction); });
    return {};
  }

  // Law 0. True if that ends the check.
  Result<bool> holdUncached() {
    REPRISE_ASSIGN(const Held held, holdPrepared(*originals_, player_->terms(nullptr, ""), interpreted_.computation));
    inconsistent_ = held.inconsistent;
    ever_inconsistent_ = ever_inconsistent_ || held.inconsistent;
    worst_ = std::max(worst_, held.inconsistent ? RoundingJudgement::kEqual : held.judgement);
    if (held.judgement != RoundingJudgement::kOurs || held.inconsistent) return false;
    REPRISE_ASSIGN(const bool undefined, showsUndefined());
    if (!undefined) fail("the prepared module, uncached", "", *held.difference);
    return true;
  }

  Result<bool> showsUndefined() {
    looked_at_undefined_ = true;
    REPRISE_ASSIGN(const CompiledShader zeros, withZeros(bench_.given));
    const LawTerms terms = player_->terms(nullptr, "");
    REPRISE_ASSIGN(const Originals* originals, originals_->get(false));
    REPRISE_ASSIGN(const std::vector<HarnessFrame> defined, player_->playWords(zeros.words));
    const auto difference = findDifference(originals->given, defined, terms, kRoundingTolerance);
    if (!difference) return false;
    // A driver may round the same expression differently beside a variable that has a value.
    REPRISE_ASSIGN(const Originals* strict, originals_->get(true));
    REPRISE_ASSIGN(const Module module, readModule(zeros.words));
    REPRISE_ASSIGN(const std::vector<HarnessFrame> strict_defined, player_->playWords(writeModule(withoutContraction(module))));
    if (!findDifference(strict->given, strict_defined, terms, kRoundingTolerance)) return false;
    end(Verdict::kUntestable, "inputs.undefined",
        fmt::format("the image shows values that nothing defines: with zeros in their place {}", placeText(*difference)));
    return true;
  }

  void noteUnshown(const std::string& code, const std::string& reason, const Candidate& candidate) {
    // An image that varies says more than one that does not.
    if (unshown_ && (unshown_->code != "image.constant" || code == "image.constant")) return;
    unshown_ = Unshown{code, reason, inputs_, originals_, &candidate, inconsistent_};
  }

  // All strategies are held to the laws, though nothing of the cache shows.
  Result<void> concludeUnshown() {
    inputs_ = unshown_->inputs;
    originals_ = unshown_->originals;
    inconsistent_ = unshown_->inconsistent;
    REPRISE_TRY(player_->setInputs(inputs_));
    verdict_.variants = 0;
    verdict_.candidates = std::max(verdict_.candidates, 1);
    REPRISE_TRY(holdCandidate(*unshown_->candidate, false));
    if (!failed()) conclude(Verdict::kUnshown, unshown_->code, unshown_->reason);
    return {};
  }

  void conclude(Verdict verdict, const std::string& code, const std::string& reason) {
    if (ever_inconsistent_) {
      end(Verdict::kUntestable, "device.inconsistent",
          "the device draws the module and its prepared form differently, though both compute the same, and all variants equal the prepared one");
      return;
    }
    const char* rounding = worst_ == RoundingJudgement::kEnlarged
                               ? "the shader enlarges rounding errors itself: bit for bit with NoContraction on both sides, and the terms are the same"
                           : worst_ == RoundingJudgement::kRounded ? "within 1e-5, where the device rounds the same terms differently"
                                                            : "";
    std::string text = reason;
    for (const std::string& note : {std::string(rounding), divergenceNote(player_->program(), player_->leftOut())})
      if (!note.empty()) text += (text.empty() ? "" : "; ") + note;
    end(verdict, code, text);
  }

  // Whether what was seen says something, if that is asked. Seen in the first strategy that takes the candidate, before time is spent
  // on the others.
  Result<bool> holdCandidate(const Candidate& candidate, bool must_show) {
    int held = 0;
    for (const Strategy& strategy : strategies()) {
      if (!strategy.selectable || (!bench_.request.strategy.empty() && strategy.name != bench_.request.strategy)) continue;
      const Result<VariantFrames> frames = holdStrategy(candidate, strategy.name);
      if (!frames.ok()) {
        if (frames.error().kind != ErrorKind::kRefused) return frames.error();
        note(strategy.name + ": " + frames.error().code);
        last_refusal_ = frames.error();
        continue;
      }
      if (failed()) return false;
      ++verdict_.variants;
      if (held++ > 0 || !must_show) continue;
      REPRISE_ASSIGN(const bool shows, showsSomething(candidate, strategy.name, frames->moving));
      if (!shows) return false;
      shown_candidate_ = &candidate;
      shown_strategy_ = strategy.name;
    }
    return held == 0 ? Result<bool>(last_refusal_) : Result<bool>(true);
  }

  Computation interpretBodiesOf(const Candidate& candidate) {
    const auto [known, is_new] = bodies_.try_emplace(candidate.id);
    if (is_new) known->second = interpretBodies(bench_.given.words, *player_->program().fragment, candidate).computation;
    return known->second;
  }

  Result<VariantFrames> holdStrategy(const Candidate& candidate, const std::string& strategy) {
    REPRISE_ASSIGN(HeldVariant variant,
                   holdVariant(*originals_, inconsistent_, [&](bool no_contraction) { return player_->variant(candidate, strategy, no_contraction); },
                               player_->terms(&candidate, strategy), [&] { return interpretBodiesOf(candidate); }));
    worst_ = std::max(worst_, variant.held.judgement);
    if (variant.held.judgement == RoundingJudgement::kOurs) {
      failed_bodies_ = interpretBodiesOf(candidate);
      fail(candidate.id + " in " + strategy, strategy, *variant.held.difference);
    }
    return std::move(variant.frames);
  }

  Result<bool> showsSomething(const Candidate& candidate, const std::string& strategy, const std::vector<HarnessFrame>& moving) {
    std::size_t hits = 0, misses = 0;
    for (std::size_t frame = 1; frame < moving.size(); ++frame) {
      hits += countKind(moving[frame], 1);
      misses += countKind(moving[frame], 2);
    }
    if (hits == 0 || misses == 0) {
      noteUnshown("inputs.one_sided", fmt::format("{}: {} pixels hit and {} missed", candidate.id, hits, misses), candidate);
      return false;
    }
    REPRISE_ASSIGN(const bool matters, player_->poisonShows(candidate, strategy, moving));
    if (!matters) noteUnshown("inputs.no_effect", candidate.id + ": a poisoned cache changes no pixel", candidate);
    return matters;
  }

  void note(const std::string& text) {
    if (std::find(verdict_.refused_strategies.begin(), verdict_.refused_strategies.end(), text) == verdict_.refused_strategies.end())
      verdict_.refused_strategies.push_back(text);
  }

  std::string placeText(const BrokenLaw& broken) const {
    const Violation& violation = broken.violation;
    std::string integers;
    for (const IntegerValue& one : inputs_.integers) integers += (integers.empty() ? ", integers " : " ") + std::to_string(one.value);
    return fmt::format("seed {}{}, frame {}, pixel ({}, {}): expected {}, found {}", inputs_.seed, integers, broken.frame, violation.pixel % inputs_.width,
                       violation.pixel / inputs_.width, violation.expected, violation.found);
  }

  void fail(const std::string& what, const std::string& strategy, const BrokenLaw& broken) {
    const char* witness = interpreted_.computation == Computation::kSame ? "the interpreter finds no other computation in the prepared module" : "the interpreter cannot say";
    end(Verdict::kFailed, broken.violation.law,
        fmt::format("{}, {} ({}); again with: {}", what, placeText(broken), witness, repeatCommand(bench_.request, inputs_.seed, strategy)));
  }

  const Bench& bench_;
  ModuleVerdict verdict_;
  std::vector<Candidate> candidates_;  // kept ones
  std::unique_ptr<ModulePlayer> player_;
  HarnessOptions inputs_;
  std::shared_ptr<OriginalFrames> originals_;
  Interpreted interpreted_;
  std::map<std::string, Computation> bodies_;  // what the interpreter says of a candidate's bodies, by its id
  Computation failed_bodies_ = Computation::kUnknown;      // of the candidate that failed
  bool inconsistent_ = false, ever_inconsistent_ = false;  // the device, with these inputs; with any
  bool may_show_undefined_ = false, looked_at_undefined_ = false;
  int shown_seeds_ = 0;
  RoundingJudgement worst_ = RoundingJudgement::kEqual;
  std::optional<Unshown> unshown_;
  const Candidate* shown_candidate_ = nullptr;  // whose cache showed, in this strategy
  std::string shown_strategy_;
  Error last_refusal_{ErrorKind::kRefused, "strategy.none", "no strategy takes this shader", {}};
};

ModuleVerdict endedBy(const CheckRequest& request, const Error& error) {
  ModuleVerdict verdict;
  verdict.path = request.path;
  verdict.verdict = error.kind == ErrorKind::kRefused ? Verdict::kRefused : Verdict::kUntestable;
  verdict.code = error.code;
  verdict.reason = error.message;
  return verdict;
}

ModuleVerdict untestable(ModuleVerdict verdict, const std::string& code, const std::string& reason) {
  verdict.verdict = Verdict::kUntestable;
  verdict.code = code;
  verdict.reason = reason;
  return verdict;
}

// A difference says nothing where the device ended the module's loops or draws the module itself now so, now so, nor where it is gone once
// undefined values are zero on our side.
// Looked at last, and whatever hinders the look leaves the failure as it is.
ModuleVerdict unlessExcused(const ModuleVerdict& failed, ModuleCheck& check, const Bench& bench) {
  if (!check.is_excusable()) return failed;
  const Result<bool> endless = loopsEndlessly(bench.given, check.inputs(), bench.context, bench.commands);
  if (endless.ok() && *endless)
    return untestable(failed, "original.endless",
                      fmt::format("with seed {} the shader itself loops more than {} times, and the device decides what comes of that",
                                  failed.seed, kEndlessIterations));
  if (const Result<bool> device = check.isDevicesFault(); device.ok() && *device)
    return untestable(failed, "device.inconsistent",
                      "the device draws a pixel of the module itself differently where other pixels beside it do not run, and the interpreter finds "
                      "no other computation in the variant");
  const Result<CompiledShader> zeros = withZeros(bench.given);
  if (!zeros.ok()) return failed;
  const ModuleVerdict defined = ModuleCheck(bench).run(*zeros);
  if (defined.verdict != Verdict::kVerified && defined.verdict != Verdict::kUnshown) return failed;
  return untestable(failed, "inputs.undefined", "the shader reads values that nothing defines; with zeros in their place all laws hold");
}

Result<ModuleVerdict> checkCompiled(const CheckRequest& request, const CheckHooks& hooks) {
  hooks.enters(CheckStage::kCompile);
  REPRISE_ASSIGN(const CompiledShader given, compile(request.path, compileOptionsOf(request)));
  ContextOptions options;
  options.device = request.device;
  REPRISE_ASSIGN(const Context context, Context::create(options));
  const std::string lacking = missingCapability(given.words, context);
  if (!lacking.empty())
    return Error{ErrorKind::kRefused, "device.capability", "the module needs the capability " + lacking + ", which the device lacks", {}};
  REPRISE_ASSIGN(const CompiledShader vertex, harnessVertex(given));
  REPRISE_ASSIGN(Commands commands, Commands::create(context));
  // The reference is started when it is first asked: many a module is refused before.
  const ReferenceModule module{request.path, request.device, vertex.words, given.words};
  std::optional<Result<Reference>> started;
  const Reference reference = [&](const ReferenceAsk& ask) -> Result<std::vector<HarnessFrame>> {
    if (!started) started = hooks.start_reference(module);
    if (!started->ok()) return started->error();
    return (**started)(ask);
  };
  const Bench bench{request, hooks, context, commands, vertex, given, reference};
  ModuleCheck check(bench);
  const ModuleVerdict verdict = check.run(given);
  return unlessExcused(verdict, check, bench);
}

}  // namespace

ModuleVerdict checkModule(const CheckRequest& request, const CheckHooks& hooks) {
  const auto start = std::chrono::steady_clock::now();
  const Result<ModuleVerdict> checked = checkCompiled(request, hooks);
  ModuleVerdict verdict = checked.ok() ? *checked : endedBy(request, checked.error());
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

}  // namespace reprise
