// libFuzzer target: any words to the SPIR-V reader. What it reads must come back from writing and reading again.
#include <cstring>
#include <string>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/source/compile.h"
#include "compiler/source/validate.h"
#include "runtime/base/file.h"
#include "tests/fuzz/mutate_words.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

// Half of the mutations keep instructions whole.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  std::minstd_rand random(seed);
  if (random() % 2 == 0) return LLVMFuzzerMutate(data, size, max_size);
  std::vector<std::uint32_t> words(size / 4);
  if (!words.empty()) std::memcpy(words.data(), data, words.size() * 4);
  reprise::mutateWords(words, max_size / 4, random);
  if (words.empty() || words.size() * 4 > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::memcpy(data, words.data(), words.size() * 4);
  return words.size() * 4;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)reprise::compileText({reinterpret_cast<const char*>(data), size}, "given.spv", {});
  std::vector<std::uint32_t> words(size / 4);
  if (!words.empty()) std::memcpy(words.data(), data, words.size() * 4);
  const reprise::Result<reprise::Module> module = reprise::readModule(words);
  if (!module.ok()) {
    REPRISE_CHECK(!module.error().code.empty(), module.error().message);
    return 0;
  }
  const reprise::Result<reprise::Module> again = reprise::readModule(reprise::writeModule(*module));
  REPRISE_CHECK(again.ok(), again.error().message);
  REPRISE_CHECK(*again == *module, words.size());
  return 0;
}
