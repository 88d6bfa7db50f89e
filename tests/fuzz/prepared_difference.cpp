#include "tests/fuzz/prepared_difference.h"

#include "cli/check/interpreted_bodies.h"
#include "cli/check/interpreter/interpret.h"
#include "compiler/analysis/analyse.h"
#include "compiler/ir/prepare.h"
#include "compiler/source/compile.h"
#include "compiler/source/validate.h"
#include "tests/fuzz/seeded_random.h"
#include "tests/fuzz/spirv_tools_passes.h"

namespace reprise {

namespace {

using Words = std::vector<std::uint32_t>;

Result<Words> prepare(std::span<const std::uint32_t> given, Promotion promotion) {
  if (promotion == Promotion::kSpirvTools) return runPassList(given, PassList::kPromotion);
  REPRISE_ASSIGN(const Module module, readModule(given));
  REPRISE_ASSIGN(const PreparedShader shader, prepareForCaching(module, ""));
  return writeModule(shader.module);
}

Judgement judged(Judgement::Verdict verdict, const std::string& what) { return {verdict, what}; }

Judgement ofError(const Error& error) {
  return judged(error.kind == ErrorKind::kRefused ? Judgement::Verdict::kRefused : Judgement::Verdict::kInvalid,
                error.code + ": " + error.message);
}

// What a variant would be made from, of the best values: the body of misses, and that of hits behind it.
std::optional<std::string> differenceOfBodies(std::span<const std::uint32_t> given) {
  constexpr int kMostCandidates = 3;
  const Result<Module> module = readModule(given);
  const Result<PreparedShader> shader = prepareForCaching(module.value(), "");
  if (!shader.ok()) return std::nullopt;
  const ShaderAnalysis analysis = analyse(*shader);
  if (analysis.refusal) return std::nullopt;
  CandidateOptions all;
  all.least_share = 0;
  int tried = 0;
  for (const Candidate& candidate : enumerateCandidates(*shader, analysis, {}, all)) {
    if (!candidate.kept()) continue;
    if (++tried > kMostCandidates) break;
    const Interpreted interpreted = interpretBodies(given, *shader, candidate);
    if (interpreted.computation == Computation::kDifferent) return "the bodies around " + candidate.id + ", " + interpreted.text;
  }
  return std::nullopt;
}

}  // namespace

std::optional<RandomModule> moduleOf(std::uint64_t seed, const std::string& text) {
  const Result<CompiledShader> compiled = compileText(text, "random.frag", {});
  if (!compiled.ok()) return std::nullopt;
  // The form has a random number of its own: the same text keeps it.
  const int choice = SeededRandom(~seed).below(8);
  const std::optional<PassList> list = choice == 0   ? std::optional(PassList::kOptimize)
                                       : choice == 1 ? std::optional(PassList::kWithoutCalls)
                                                     : std::nullopt;
  if (list) {
    Result<Words> optimized = runPassList(compiled->words, *list);
    // A pass that gives up or makes an invalid module leaves it as compiled.
    if (optimized.ok() && validateModule(*optimized).ok())
      return RandomModule{text, list == PassList::kOptimize ? "optimized" : "optimized, with calls", std::move(*optimized)};
  }
  return RandomModule{text, "as compiled", compiled->words};
}

RandomModule randomModule(std::uint64_t seed, const RandomShaderOptions& options) {
  const std::string text = randomShader(seed, options);
  std::optional<RandomModule> module = moduleOf(seed, text);
  REPRISE_CHECK(module.has_value(), "the shader of seed " + std::to_string(seed) + " is not valid:\n" + text);
  return std::move(*module);
}

Judgement judgePreparation(std::span<const std::uint32_t> given, Promotion promotion) {
  using Verdict = Judgement::Verdict;
  const Result<Words> prepared = prepare(given, promotion);
  if (!prepared.ok()) return ofError(prepared.error());
  if (const Result<void> valid = validateModule(*prepared); !valid.ok()) return judged(Verdict::kInvalid, valid.error().message);
  CompareCounts counts;
  const auto compared = compareComputations(given, *prepared, "", CompareOptions{}, &counts);
  if (!compared.ok()) return judged(Verdict::kUntold, compared.error().message);
  Judgement judgement{Verdict::kSame, "", counts.undefined, counts.endless, counts.returned, counts.discarded};
  if (const std::optional<ComputationDifference>& difference = *compared) {
    judgement.verdict = Verdict::kDifferent;
    judgement.what = "at (" + std::to_string(difference->frag_x) + ", " + std::to_string(difference->frag_y) + ") with inputs " +
                     std::to_string(difference->seed) + ": " + difference->found + " instead of " + difference->expected;
  } else if (counts.returned + counts.discarded == 0) {
    judgement.verdict = Verdict::kUntold;
    judgement.what = "no sampled point says anything";
  } else if (promotion == Promotion::kOurs) {
    if (const std::optional<std::string> bodies = differenceOfBodies(given)) {
      judgement.verdict = Verdict::kDifferent;
      judgement.what = *bodies;
    }
  }
  return judgement;
}

std::optional<std::string> differenceOf(std::uint64_t seed, Promotion promotion) {
  const RandomModule module = randomModule(seed);
  const Judgement judgement = judgePreparation(module.words, promotion);
  if (!judgement.finding()) return std::nullopt;
  return "seed " + std::to_string(seed) + " (" + module.form + "): " + judgement.what;
}

}  // namespace reprise
