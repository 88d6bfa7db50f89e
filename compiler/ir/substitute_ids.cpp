#include "compiler/ir/substitute_ids.h"

namespace reprise {
namespace {

using Ids = std::unordered_map<std::uint32_t, std::uint32_t>;

// Shortens the way that it went, so that long chains of copies are walked once.
std::uint32_t resolve(Ids& replacements, std::uint32_t id) {
  std::uint32_t end = id;
  for (auto found = replacements.find(end); found != replacements.end(); found = replacements.find(end)) end = found->second;
  for (auto found = replacements.find(id); found != replacements.end() && found->second != end; found = replacements.find(id)) {
    id = found->second;
    found->second = end;
  }
  return end;
}

}  // namespace

void substituteIds(Function& function, Ids replacements) {
  if (replacements.empty()) return;
  for (Block& block : function.blocks)
    for (Instruction& instruction : block.instructions)
      for (Operand& operand : instruction.operands)
        if (operand.is_id) operand.words[0] = resolve(replacements, operand.words[0]);
}

}  // namespace reprise
