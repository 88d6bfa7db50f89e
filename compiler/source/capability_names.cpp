#include "compiler/source/capability_names.h"

#include <sstream>

#include "compiler/source/validate.h"

namespace reprise {

std::vector<std::string> capabilityNames(std::span<const std::uint32_t> words) {
  constexpr std::uint32_t kCapability = 17;
  // Capabilities come first in a module; only that part is disassembled.
  std::size_t end = 5;
  while (end < words.size() && (words[end] & 0xffffu) == kCapability && words[end] >> 16 == 2) end += 2;
  std::istringstream text(disassemble(words.first(std::min(end, words.size()))));
  std::vector<std::string> names;
  std::string word;
  while (text >> word) {
    if (word != "OpCapability" || !(text >> word)) continue;
    for (const char* suffix : {"EXT", "KHR", "NV", "AMD"})
      if (word.ends_with(suffix)) word.resize(word.size() - std::string(suffix).size());
    names.push_back(word);
  }
  return names;
}

}  // namespace reprise
