// fuzz_structured [--first N] [--count N] [--promotion ours|spirv-tools] [--out FOLDER] [--reduce]: random structured shaders, prepared and held
// against themselves by the interpreter. Prints each finding with its seed and, with --out, writes its text into FOLDER; --reduce makes that
// text short. The exit status is 1 if there are findings, 2 if the words are wrong.
#include <charconv>
#include <iostream>

#include "runtime/base/file.h"
#include "tests/fuzz/prepared_difference.h"
#include "tests/fuzz/reduce_shader.h"

namespace {

using namespace reprise;

struct Run {
  std::uint64_t first = 1, count = 200;
  Promotion promotion = Promotion::kOurs;
  std::string out;
  bool reduce = false;
};

std::optional<std::uint64_t> numberOf(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && !text.empty() ? std::optional(number) : std::nullopt;
}

bool takeWord(Run& run, const std::string& word, const std::string& value) {
  if (word == "--out") run.out = value;
  if (word == "--promotion") run.promotion = value == "ours" ? Promotion::kOurs : Promotion::kSpirvTools;
  if (word == "--out") return true;
  if (word == "--promotion") return value == "ours" || value == "spirv-tools";
  const std::optional<std::uint64_t> number = numberOf(value);
  if (!number) return false;
  if (word == "--first") run.first = *number;
  if (word == "--count") run.count = *number;
  return word == "--first" || word == "--count";
}

std::optional<Run> readWords(int count, char** words) {
  Run run;
  for (int i = 1; i < count; ++i) {
    if (std::string(words[i]) == "--reduce") {
      run.reduce = true;
      continue;
    }
    if (i + 1 >= count || !takeWord(run, words[i], words[i + 1])) return std::nullopt;
    ++i;
  }
  return run;
}

const char* wordsOf(Judgement::Verdict verdict) {
  switch (verdict) {
    case Judgement::Verdict::kSame: return "is the same";
    case Judgement::Verdict::kRefused: return "is refused";
    case Judgement::Verdict::kUntold: return "is not told";
    case Judgement::Verdict::kInvalid: return "becomes invalid";
    case Judgement::Verdict::kDifferent: return "differs";
  }
  return "";
}

void writeFinding(const Run& run, std::uint64_t seed, std::string text, Judgement::Verdict verdict) {
  const auto shows = [&](const std::string& shorter) {
    const std::optional<RandomModule> module = moduleOf(seed, shorter);
    return module && judgePreparation(module->words, run.promotion).verdict == verdict;
  };
  if (run.reduce) text = reduceShader(text, shows);
  const std::string path = run.out + "/seed" + std::to_string(seed) + ".frag";
  if (const Result<void> written = writeFile(path, text); !written.ok()) std::cerr << written.error().message << "\n";
}

}  // namespace

int main(int count, char** words) {
  const std::optional<Run> run = readWords(count, words);
  if (!run) {
    std::cerr << "usage: fuzz_structured [--first N] [--count N] [--promotion ours|spirv-tools] [--out FOLDER] [--reduce]\n";
    return 2;
  }
  using Verdict = Judgement::Verdict;
  std::uint64_t findings = 0, refused = 0, untold = 0, undefined = 0, discarded = 0, optimized = 0;
  for (std::uint64_t done = 0; done < run->count; ++done) {
    const std::uint64_t seed = run->first + done;
    const RandomModule module = randomModule(seed);
    const Judgement judgement = judgePreparation(module.words, run->promotion);
    refused += judgement.verdict == Verdict::kRefused ? 1 : 0;
    untold += judgement.verdict == Verdict::kUntold ? 1 : 0;
    undefined += judgement.undefined > 0 ? 1 : 0;
    discarded += judgement.discarded > 0 ? 1 : 0;
    optimized += module.form != "as compiled" ? 1 : 0;
    findings += judgement.finding() ? 1 : 0;
    if (judgement.verdict != Verdict::kSame)
      std::cout << "seed " << seed << " (" << module.form << ") " << wordsOf(judgement.verdict) << ": " << judgement.what << std::endl;
    if (judgement.finding() && !run->out.empty()) writeFinding(*run, seed, module.text, judgement.verdict);
    if ((done + 1) % 100 == 0) std::cout << done + 1 << " of " << run->count << " modules, " << findings << " findings" << std::endl;
  }
  std::cout << run->count << " modules from seed " << run->first << " (" << optimized << " optimized): " << findings << " findings, " << refused
            << " refused, " << untold << " not told, " << undefined << " with undefined behaviour, " << discarded << " that discard" << std::endl;
  return findings == 0 ? 0 : 1;
}
