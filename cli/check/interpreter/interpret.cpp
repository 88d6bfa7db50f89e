#include "cli/check/interpreter/interpret.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>

#include "cli/check/interpreter/interface.h"
#include "cli/check/interpreter/machine.h"

namespace reprise {
namespace {

using interpreter::Machine;
using interpreter::Program;
using Ending = Interpretation::Ending;

constexpr int kImageSize = 64, kSeedsAtOnce = 4;
// What a rewritten module may need for what the given one computes: tests of flags, copies.
constexpr std::uint64_t kStepsOfPrepared = 8, kFewSteps = 10000;

// reached: by number, the blocks that this run or one before came to; null where nobody asks.
Result<Interpretation> interpret(const Program& program, const InterpreterInputs& inputs, std::vector<bool>* reached = nullptr) {
  Machine machine(program, inputs);
  machine.run();
  if (machine.failure) return *machine.failure;
  for (std::size_t i = 0; reached != nullptr && i < reached->size(); ++i)
    if (machine.reached[i]) (*reached)[i] = true;
  Interpretation result;
  result.ending = machine.ending;
  result.side_effects = machine.side_effects;
  result.reads_undefined = machine.reads_undefined;
  result.undefined_behaviour = machine.undefined_behaviour;
  result.steps = machine.steps;
  if (result.ending == Ending::kReturned) result.outputs = interpreter::outputsOf(machine);
  for (const OutputWord& word : result.outputs) result.reads_undefined = result.reads_undefined || word.undefined;
  return result;
}

const char* nameOf(Ending ending) {
  switch (ending) {
    case Ending::kReturned: return "it returns";
    case Ending::kDiscarded: return "it discards";
    case Ending::kEndless: return "it does not end";
  }
  return "";
}

std::string hexadecimal(std::uint64_t number) {
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(number));
  return text.data();
}

std::string describe(const OutputWord& word) {
  std::string place = "output " + std::to_string(word.location) + "." + std::to_string(word.component);
  if (word.location >= kBuiltInLocation) place = "built-in output " + std::to_string(word.location - kBuiltInLocation) + "." + std::to_string(word.component);
  if (word.undefined) return place + " is undefined";
  std::array<char, 40> number{};
  if (word.is_float) std::snprintf(number.data(), number.size(), "%.9g", static_cast<double>(std::bit_cast<float>(word.bits)));
  else std::snprintf(number.data(), number.size(), "%u", word.bits);
  return place + " = " + number.data() + " (computation " + hexadecimal(word.hash) + ")";
}

struct Texts {
  std::string expected, found;
};

const OutputWord* find(const std::vector<OutputWord>& words, const OutputWord& like) {
  const auto same = [&](const OutputWord& one) { return one.location == like.location && one.component == like.component; };
  const auto found = std::find_if(words.begin(), words.end(), same);
  return found == words.end() ? nullptr : &*found;
}

std::optional<Texts> differenceOf(const Interpretation& given, const Interpretation& prepared) {
  if (given.ending != prepared.ending) return Texts{nameOf(given.ending), nameOf(prepared.ending)};
  if (given.side_effects != prepared.side_effects)
    return Texts{"writes to buffers and images (" + hexadecimal(given.side_effects) + ")", "other writes (" + hexadecimal(prepared.side_effects) + ")"};
  for (const OutputWord& word : given.outputs) {
    if (word.undefined) continue;
    const OutputWord* found = find(prepared.outputs, word);
    if (found == nullptr) return Texts{describe(word), "no such output"};
    if (found->undefined || found->bits != word.bits || found->hash != word.hash) return Texts{describe(word), describe(*found)};
  }
  for (const OutputWord& word : prepared.outputs)
    if (!word.undefined && find(given.outputs, word) == nullptr) return Texts{"no such output", describe(word)};
  return std::nullopt;
}

// Point `number` of `count` on a grid over the image, moved a little by the seed.
void placeAt(InterpreterInputs& inputs, int number, int count) {
  int across = 1;
  while (across * across < count) ++across;
  const std::uint64_t moved = interpreter::mixed(inputs.seed, static_cast<std::uint64_t>(number));
  const int cell = std::max(kImageSize / across, 1);
  const auto inside = [&](int index, std::uint64_t move) { return static_cast<float>(std::min(index * cell + static_cast<int>(move % static_cast<std::uint64_t>(cell)), kImageSize - 1)) + 0.5f; };
  inputs.frag_x = inside(number % across, moved & 0xffff);
  inputs.frag_y = inside(number / across, (moved >> 16) & 0xffff);
}

class Comparison {
 public:
  Comparison(const Program& given, const Program& prepared, const CompareOptions& options) : given_(given), prepared_(prepared), options_(options) {
    reached_.resize(given.blocks);
  }

  Result<std::optional<ComputationDifference>> run() {
    REPRISE_ASSIGN(auto difference, compareOver(0, options_.seeds));
    for (int done = 0; done < options_.more_seeds && !difference && unreached() > 0; done += kSeedsAtOnce) {
      REPRISE_ASSIGN(difference, compareOver(options_.seeds + done, options_.seeds + std::min(done + kSeedsAtOnce, options_.more_seeds)));
    }
    counts_.unreached = unreached();
    return difference;
  }

  CompareCounts counts() const { return counts_; }

 private:
  Result<std::optional<ComputationDifference>> compareOver(int first, int end) {
    // Points of all seeds in turn, so that a budget that ends early leaves out points and not seeds.
    for (int point = 0; point < options_.points; ++point)
      for (int s = first; s < end; ++s) {
        if (steps_ >= options_.most_steps_together) return std::optional<ComputationDifference>{};
        InterpreterInputs inputs;
        inputs.seed = options_.first_seed + static_cast<std::uint32_t>(s);
        placeAt(inputs, point, options_.points);
        REPRISE_ASSIGN(const std::optional<Texts> texts, compareAt(inputs));
        if (texts) return std::optional(ComputationDifference{inputs.frag_x, inputs.frag_y, inputs.seed, texts->expected, texts->found});
      }
    return std::optional<ComputationDifference>{};
  }

  // Of functions that were called; their first block was reached then.
  int unreached() {
    int missing = 0;
    counts_.blocks = 0;
    for (const interpreter::Function& function : given_.functions) {
      if (function.blocks.empty() || !reached_[function.blocks[0].number]) continue;
      counts_.blocks += static_cast<int>(function.blocks.size());
      for (const interpreter::Block& block : function.blocks) missing += reached_[block.number] ? 0 : 1;
    }
    return missing;
  }

  Result<std::optional<Texts>> compareAt(InterpreterInputs inputs) {
    inputs.most_steps = options_.most_steps;
    REPRISE_ASSIGN(const Interpretation given, interpret(given_, inputs, &reached_));
    steps_ += given.steps;
    if (given.ending == Ending::kEndless) {
      ++counts_.endless;
      return std::optional<Texts>{};
    }
    inputs.most_steps = kStepsOfPrepared * given.steps + kFewSteps;
    REPRISE_ASSIGN(const Interpretation prepared, interpret(prepared_, inputs));
    const std::optional<Texts> texts = differenceOf(given, prepared);
    if (texts && given.undefined_behaviour) {
      ++counts_.undefined;
      return std::optional<Texts>{};
    }
    ++(given.ending == Ending::kDiscarded ? counts_.discarded : counts_.returned);
    return texts;
  }

  const Program& given_;
  const Program& prepared_;
  const CompareOptions& options_;
  CompareCounts counts_;
  std::vector<bool> reached_;
  std::uint64_t steps_ = 0;
};

}  // namespace

Result<Interpretation> interpretFragment(std::span<const std::uint32_t> words, const std::string& entry_point, const InterpreterInputs& inputs) {
  REPRISE_ASSIGN(const Program program, interpreter::readProgram(words, entry_point));
  return interpret(program, inputs);
}

Result<std::optional<ComputationDifference>> compareComputations(std::span<const std::uint32_t> given, std::span<const std::uint32_t> prepared,
                                                                 const std::string& entry_point, const CompareOptions& options, CompareCounts* counts) {
  REPRISE_ASSIGN(const Program given_program, interpreter::readProgram(given, entry_point));
  REPRISE_ASSIGN(const Program prepared_program, interpreter::readProgram(prepared, entry_point));
  Comparison comparison(given_program, prepared_program, options);
  auto difference = comparison.run();
  if (counts != nullptr) *counts = comparison.counts();
  return difference;
}

}  // namespace reprise
