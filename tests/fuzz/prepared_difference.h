// Random modules held against what preparation makes of them; the interpreter of cli/check tells whether both compute the same.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "runtime/base/result.h"
#include "tests/fuzz/random_shader.h"

namespace reprise {

// Who prepares: the project, or SPIRV-Tools in its place.
enum class Promotion { kOurs, kSpirvTools };

struct RandomModule {
  std::string text;
  std::string form;  // "as compiled", "optimized", "optimized, with calls"
  std::vector<std::uint32_t> words;
};

// The shader of a seed, compiled; one in four has been through an optimizer as well. It is valid.
RandomModule randomModule(std::uint64_t seed, const RandomShaderOptions& options = {});
// The same of a text that need not be valid: nullopt where it is not.
std::optional<RandomModule> moduleOf(std::uint64_t seed, const std::string& text);

struct Judgement {
  enum class Verdict {
    kSame,
    kRefused,    // preparation refuses it, with a code
    kUntold,     // the interpreter does not know an instruction, or no sampled point says anything
    kInvalid,    // preparation fails, or gives an invalid module
    kDifferent,  // another computation
  };
  Verdict verdict = Verdict::kSame;
  std::string what;        // one line; empty for kSame
  bool finding() const { return verdict == Verdict::kInvalid || verdict == Verdict::kDifferent; }
  int undefined = 0;       // sampled points at which the given module's behaviour is undefined
  int endless = 0;         // that it did not come to an end in
  int returned = 0, discarded = 0;
};

Judgement judgePreparation(std::span<const std::uint32_t> given, Promotion promotion);

// "seed 17 (as compiled): ...", or nothing where the seed's module is no finding.
std::optional<std::string> differenceOf(std::uint64_t seed, Promotion promotion);

}  // namespace reprise
