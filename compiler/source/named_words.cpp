#include "compiler/source/named_words.h"

#include <cstring>

namespace reprise {
namespace {

using spv::Op;

constexpr std::size_t kHeaderWords = 5;

std::string textOf(std::span<const std::uint32_t> words) {
  const char* text = reinterpret_cast<const char*>(words.data());
  return {text, strnlen(text, words.size() * 4)};
}

void append(std::vector<std::uint32_t>& words, Op opcode, std::vector<std::uint32_t> operands, const std::string& text) {
  std::vector<std::uint32_t> letters(text.size() / 4 + 1, 0);
  std::memcpy(letters.data(), text.data(), text.size());
  operands.insert(operands.end(), letters.begin(), letters.end());
  words.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | static_cast<std::uint32_t>(opcode));
  words.insert(words.end(), operands.begin(), operands.end());
}

// What may stand before the end of the names.
bool precedesNames(Op opcode) {
  switch (opcode) {
    case Op::OpCapability:
    case Op::OpExtension:
    case Op::OpExtInstImport:
    case Op::OpMemoryModel:
    case Op::OpEntryPoint:
    case Op::OpExecutionMode:
    case Op::OpExecutionModeId:
    case Op::OpString:
    case Op::OpSource:
    case Op::OpSourceContinued:
    case Op::OpSourceExtension:
    case Op::OpName:
    case Op::OpMemberName: return true;
    default: return false;
  }
}

bool isType(Op opcode) { return opcode >= Op::OpTypeVoid && opcode <= Op::OpTypePipe; }

}  // namespace

NamedWords::NamedWords(std::span<const std::uint32_t> words) : words_(words) {
  for (std::size_t at = kHeaderWords; at < words.size(); at += words[at] >> 16) {
    const auto opcode = static_cast<Op>(words[at] & 0xffffu);
    if (opcode == Op::OpFunction) return;
    read(opcode, words.subspan(at + 1, (words[at] >> 16) - 1));
  }
}

void NamedWords::read(Op opcode, std::span<const std::uint32_t> operands) {
  const auto third = operands.size() > 2 ? operands[2] : 0;
  if (opcode == Op::OpEntryPoint) stage_ = static_cast<spv::ExecutionModel>(operands[0]);
  if (opcode == Op::OpName) names_[operands[0]] = textOf(operands.subspan(1));
  if (opcode == Op::OpMemberName) member_names_[{operands[0], operands[1]}] = textOf(operands.subspan(2));
  if (opcode == Op::OpDecorate) decorations_[{operands[0], static_cast<spv::Decoration>(operands[1])}] = third;
  if (opcode == Op::OpMemberDecorate)
    member_decorations_[{{operands[0], operands[1]}, static_cast<spv::Decoration>(third)}] = operands.size() > 3 ? operands[3] : 0;
  if (opcode == Op::OpConstant || opcode == Op::OpSpecConstant) constants_[operands[1]] = operands[2];
  if (isType(opcode)) types_[operands[0]] = {opcode, {operands.begin() + 1, operands.end()}};
  if (opcode == Op::OpVariable)
    if (const Type* pointer = type(operands[0]); pointer != nullptr && pointer->opcode == Op::OpTypePointer)
      variables_.push_back({operands[1], withoutArrays(pointer->operands[1]), static_cast<spv::StorageClass>(operands[2])});
}

const NamedWords::Type* NamedWords::type(std::uint32_t id) const {
  const auto found = types_.find(id);
  return found == types_.end() ? nullptr : &found->second;
}

std::uint32_t NamedWords::withoutArrays(std::uint32_t id) const {
  for (const Type* one = type(id); one != nullptr && (one->opcode == Op::OpTypeArray || one->opcode == Op::OpTypeRuntimeArray); one = type(id))
    id = one->operands[0];
  return id;
}

std::optional<std::uint32_t> NamedWords::decoration(std::uint32_t id, spv::Decoration decoration) const {
  const auto found = decorations_.find({id, decoration});
  return found == decorations_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::uint32_t> NamedWords::memberDecoration(std::uint32_t type, std::uint32_t member, spv::Decoration decoration) const {
  const auto found = member_decorations_.find({{type, member}, decoration});
  return found == member_decorations_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::uint32_t> NamedWords::constant(std::uint32_t id) const {
  const auto found = constants_.find(id);
  return found == constants_.end() ? std::nullopt : std::optional(found->second);
}

std::string NamedWords::name(std::uint32_t id) const {
  const auto found = names_.find(id);
  return found == names_.end() ? "" : found->second;
}

std::string NamedWords::memberName(std::uint32_t type, std::uint32_t member) const {
  const auto found = member_names_.find({type, member});
  return found == member_names_.end() ? "" : found->second;
}

void NamedWords::setName(std::uint32_t id, const std::string& wanted) {
  if (name(id) == wanted) return;
  names_[id] = wanted;
  changed_ = true;
}

void NamedWords::setMemberName(std::uint32_t type, std::uint32_t member, const std::string& wanted) {
  if (memberName(type, member) == wanted) return;
  member_names_[{type, member}] = wanted;
  changed_ = true;
}

std::vector<std::uint32_t> NamedWords::take() const {
  if (!changed_) return {words_.begin(), words_.end()};
  std::vector<std::uint32_t> result(words_.begin(), words_.begin() + kHeaderWords);
  std::size_t at = kHeaderWords;
  for (; at < words_.size(); at += words_[at] >> 16) {
    const auto opcode = static_cast<Op>(words_[at] & 0xffffu);
    if (!precedesNames(opcode)) break;
    if (opcode == Op::OpName || opcode == Op::OpMemberName) continue;
    result.insert(result.end(), words_.begin() + static_cast<std::ptrdiff_t>(at), words_.begin() + static_cast<std::ptrdiff_t>(at + (words_[at] >> 16)));
  }
  for (const auto& [id, text] : names_)
    if (!text.empty()) append(result, Op::OpName, {id}, text);
  for (const auto& [member, text] : member_names_)
    if (!text.empty()) append(result, Op::OpMemberName, {member.first, member.second}, text);
  result.insert(result.end(), words_.begin() + static_cast<std::ptrdiff_t>(at), words_.end());
  return result;
}

}  // namespace reprise
