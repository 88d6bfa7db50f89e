#include "cli/check/reference/no_contraction.h"

#include <algorithm>
#include <cstring>
#include <set>

namespace reprise {
namespace {

// Numbers of the specification (unified1); the names are its own.
enum Opcode : std::uint32_t {
  kOpExtInstImport = 11, kOpExtInst = 12, kOpTypeVoid = 19, kOpFunction = 54, kOpDecorate = 71, kOpMemberDecorate = 72, kOpDecorationGroup = 73, kOpGroupDecorate = 74,
  kOpGroupMemberDecorate = 75, kOpFNegate = 127, kOpFAdd = 129, kOpFSub = 131, kOpFMul = 133, kOpFDiv = 136, kOpFRem = 140, kOpFMod = 141,
  kOpVectorTimesScalar = 142, kOpDot = 148, kOpDecorateId = 332, kOpDecorateString = 5632, kOpMemberDecorateString = 5633
};
constexpr std::uint32_t kNoContraction = 42;
constexpr std::size_t kHeaderWords = 5, kDecorationWords = 3;

// From OpVectorTimesScalar to OpDot all are products and sums of floats.
bool isFloatArithmetic(std::uint32_t opcode) {
  switch (opcode) {
    case kOpFNegate:
    case kOpFAdd:
    case kOpFSub:
    case kOpFMul:
    case kOpFDiv:
    case kOpFRem:
    case kOpFMod: return true;
    default: return opcode >= kOpVectorTimesScalar && opcode <= kOpDot;
  }
}

bool isAnnotation(std::uint32_t opcode) {
  switch (opcode) {
    case kOpDecorate:
    case kOpMemberDecorate:
    case kOpDecorationGroup:
    case kOpGroupDecorate:
    case kOpGroupMemberDecorate:
    case kOpDecorateId:
    case kOpDecorateString:
    case kOpMemberDecorateString: return true;
    default: return false;
  }
}

bool isImportOf(std::span<const std::uint32_t> instruction, const char* name) {
  const std::size_t length = std::strlen(name);
  return instruction.size() * 4 >= 8 + length + 1 && std::memcmp(&instruction[2], name, length + 1) == 0;
}

bool declaresType(std::uint32_t opcode) { return (opcode >= kOpTypeVoid && opcode <= kOpFunction); }

}  // namespace

std::vector<std::uint32_t> withNoContraction(std::span<const std::uint32_t> words) {
  std::set<std::uint32_t> decorated;
  std::vector<std::uint32_t> wanted;
  std::size_t annotations_end = 0, first_declaration = 0;
  bool in_function = false;
  std::uint32_t functions_set = 0;  // GLSL.std.450
  for (std::size_t at = kHeaderWords; at < words.size();) {
    const std::uint32_t opcode = words[at] & 0xffffu;
    const std::size_t length = std::max<std::size_t>(words[at] >> 16, 1);
    if (isAnnotation(opcode)) annotations_end = at + length;
    if (opcode == kOpDecorate && length == kDecorationWords && words[at + 2] == kNoContraction) decorated.insert(words[at + 1]);
    if (first_declaration == 0 && declaresType(opcode)) first_declaration = at;
    in_function = in_function || opcode == kOpFunction;
    if (opcode == kOpExtInstImport && isImportOf(words.subspan(at, length), "GLSL.std.450")) functions_set = words[at + 1];
    const bool calls = opcode == kOpExtInst && length > 4 && words[at + 3] == functions_set;
    if (in_function && (calls || (isFloatArithmetic(opcode) && length > 2))) wanted.push_back(words[at + 2]);
    at += length;
  }
  const std::size_t place = annotations_end != 0 ? annotations_end : first_declaration != 0 ? first_declaration : words.size();
  std::vector<std::uint32_t> result(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(place));
  for (const std::uint32_t id : wanted)
    if (decorated.insert(id).second) result.insert(result.end(), {static_cast<std::uint32_t>(kDecorationWords << 16) | kOpDecorate, id, kNoContraction});
  result.insert(result.end(), words.begin() + static_cast<std::ptrdiff_t>(place), words.end());
  return result;
}

}  // namespace reprise
