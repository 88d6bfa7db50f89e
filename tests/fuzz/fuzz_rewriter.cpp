// libFuzzer target: mutated valid modules through the rewriter. What spirv-val accepts must come out as a Result, and every
// module of every variant must be valid.
#include <cstring>
#include <vector>

#include "compiler/source/validate.h"
#include "runtime/base/hash.h"
#include "tests/fuzz/mutate_words.h"
#include "tests/fuzz/rewrite_all.h"

namespace {

constexpr int kAttempts = 6;  // at a mutation that leaves the module valid
constexpr int kMostMutations = 2;
constexpr std::size_t kCandidates = 1;

std::vector<std::uint32_t> wordsOf(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint32_t> words(size / 4);
  if (!words.empty()) std::memcpy(words.data(), data, words.size() * 4);
  return words;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  std::minstd_rand random(seed);
  const std::vector<std::uint32_t> original = wordsOf(data, size);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::vector<std::uint32_t> words = original;
    for (std::size_t i = 0; i <= random() % kMostMutations; ++i) reprise::mutateWords(words, max_size / 4, random);
    if (words == original || words.size() * 4 > max_size || !reprise::validateModule(words).ok()) continue;
    std::memcpy(data, words.data(), words.size() * 4);
    return words.size() * 4;
  }
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::uint32_t> words = wordsOf(data, size);
  if (size % 4 != 0 || !reprise::validateModule(words).ok()) return -1;
  const std::string hash = reprise::contentHash({reinterpret_cast<const char*>(data), size});
  const auto choices = static_cast<std::uint32_t>(std::stoul(hash.substr(0, 4), nullptr, 16));
  (void)reprise::rewriteAll(words, {kCandidates, choices});
  return 0;
}
