#include "cli/check/interpreter/read_types.h"

#include <algorithm>

#include "cli/check/interpreter/machine.h"

namespace reprise::interpreter {
namespace {

using spv::Decoration;
using spv::Op;

constexpr std::uint32_t kWhole = 0xffffffff;
constexpr std::uint32_t kDeepest = 64;

void apply(Decorations& to, Decoration decoration, std::uint32_t word) {
  switch (decoration) {
    case Decoration::Location: to.location = word; break;
    case Decoration::Component: to.component = word; break;
    case Decoration::Index: to.index = word; break;
    case Decoration::BuiltIn: to.built_in = word; break;
    case Decoration::DescriptorSet: to.set = word; break;
    case Decoration::Binding: to.binding = word; break;
    case Decoration::Offset: to.offset = word; break;
    case Decoration::ArrayStride: to.array_stride = word; break;
    case Decoration::MatrixStride: to.matrix_stride = word; break;
    case Decoration::RowMajor: to.row_major = true; break;
    case Decoration::Block: case Decoration::BufferBlock: to.block = true; break;
    case Decoration::Flat: to.interpolation |= 1; break;
    case Decoration::NoPerspective: to.interpolation |= 2; break;
    case Decoration::Centroid: to.interpolation |= 4; break;
    case Decoration::Sample: to.interpolation |= 8; break;
    default: break;
  }
}

// What a group gives to one of its targets.
void merge(Decorations& to, const Decorations& group) {
  const auto take = [](auto& mine, const auto& theirs) {
    if (theirs) mine = theirs;
  };
  take(to.location, group.location), take(to.component, group.component), take(to.index, group.index);
  take(to.built_in, group.built_in), take(to.set, group.set), take(to.binding, group.binding);
  take(to.offset, group.offset), take(to.array_stride, group.array_stride), take(to.matrix_stride, group.matrix_stride);
  take(to.row_major, group.row_major), take(to.block, group.block);
  to.interpolation |= group.interpolation;
}

bool isDescriptor(const Type& type) {
  return type.descriptor || type.kind == Kind::kImage || type.kind == Kind::kSampler || type.kind == Kind::kSampledImage;
}

}  // namespace

bool isDecoration(Op op) {
  switch (op) {
    case Op::OpDecorate: case Op::OpMemberDecorate: case Op::OpDecorateId: case Op::OpDecorationGroup: case Op::OpGroupDecorate:
    case Op::OpGroupMemberDecorate: return true;
    default: return false;
  }
}

bool isType(Op op) {
  switch (op) {
    case Op::OpTypeVoid: case Op::OpTypeBool: case Op::OpTypeInt: case Op::OpTypeFloat: case Op::OpTypeVector: case Op::OpTypeMatrix:
    case Op::OpTypeImage: case Op::OpTypeSampler: case Op::OpTypeSampledImage: case Op::OpTypeArray: case Op::OpTypeRuntimeArray:
    case Op::OpTypeStruct: case Op::OpTypePointer: case Op::OpTypeFunction: case Op::OpTypeAccelerationStructureKHR:
    case Op::OpTypeRayQueryKHR: return true;
    default: return false;
  }
}

Decorations TypeReader::decorationsOf(std::uint32_t id) const {
  const auto found = decorations_.find({id, kWhole});
  return found == decorations_.end() ? Decorations{} : found->second;
}

Result<void> TypeReader::decorate(Op op, std::uint32_t, std::span<const std::uint32_t> operands) {
  const bool member = op == Op::OpMemberDecorate;
  if (op == Op::OpDecorate || member) {
    const std::size_t first = member ? 2 : 1;
    if (operands.size() <= first) return invalid("a decoration is too short");
    Decorations& to = decorations_[{operands[0], member ? operands[1] : kWhole}];
    apply(to, static_cast<Decoration>(operands[first]), operands.size() > first + 1 ? operands[first + 1] : 0);
  } else if (op == Op::OpGroupDecorate || op == Op::OpGroupMemberDecorate) {
    if (operands.empty()) return invalid("a decoration is too short");
    const Decorations group = decorationsOf(operands[0]);
    const bool members = op == Op::OpGroupMemberDecorate;
    for (std::size_t i = 1; i + (members ? 1 : 0) < operands.size(); i += members ? 2 : 1)
      merge(decorations_[{operands[i], members ? operands[i + 1] : kWhole}], group);
  }
  return {};
}

const Type* TypeReader::typeAt(std::span<const std::uint32_t> operands, std::size_t index, std::uint32_t& number) const {
  if (index >= operands.size() || operands[index] >= program_.ids.size()) return nullptr;
  const IdInfo& info = program_.ids[operands[index]];
  if (info.what != IdInfo::What::kType) return nullptr;
  number = info.type;
  return &program_.types[number];
}

Result<void> TypeReader::makeRow(Type& type, std::span<const std::uint32_t> operands, std::uint64_t count) {
  const Type* element = typeAt(operands, 0, type.element);
  if (element == nullptr) return invalid("a type is made of no type");
  type.count = static_cast<std::uint32_t>(count);
  type.flat = static_cast<std::uint32_t>(std::min<std::uint64_t>(count * element->flat, kMostScalars + 1));
  if (element->flat == 0 && count > kMostScalars) type.flat = kMostScalars + 1;
  type.scalar = element->scalar;
  type.depth = element->depth + 1;
  type.descriptor = (type.kind == Kind::kArray || type.kind == Kind::kRuntimeArray) && isDescriptor(*element);
  return {};
}

Result<void> TypeReader::defineStruct(Type& type, std::uint32_t result, std::span<const std::uint32_t> members) {
  type.descriptor = decorationsOf(result).block;
  if (members.size() > kMostScalars) return unsupported("structures of so many members");
  for (std::uint32_t i = 0; i < members.size(); ++i) {
    Member member;
    const Type* of = typeAt(members, i, member.type);
    if (of == nullptr) return invalid("a member has no type");
    member.first = type.flat;
    if (const auto found = decorations_.find({result, i}); found != decorations_.end()) member.decorations = found->second;
    type.flat = std::min(type.flat + of->flat, kMostScalars + 1);
    type.depth = std::max(type.depth, of->depth + 1);
    type.members.push_back(member);
  }
  type.count = static_cast<std::uint32_t>(members.size());
  return {};
}

Result<void> TypeReader::define(Op op, std::uint32_t result, std::span<const std::uint32_t> operands) {
  if (program_.ids[result].what != IdInfo::What::kNothing) return invalid("an id is defined twice");
  Type type;
  const auto number = static_cast<std::uint32_t>(program_.types.size());
  const auto operand = [&](std::size_t i) { return i < operands.size() ? operands[i] : 0; };
  type.scalar = number;
  type.array_stride = decorationsOf(result).array_stride;
  switch (op) {
    case Op::OpTypeVoid: type.kind = Kind::kVoid; break;
    case Op::OpTypeBool: type.kind = Kind::kBool, type.width = 1, type.flat = 1; break;
    case Op::OpTypeInt:
    case Op::OpTypeFloat:
      type.kind = op == Op::OpTypeInt ? Kind::kInt : Kind::kFloat, type.width = operand(0), type.flat = 1;
      if (type.width != 8 && type.width != 16 && type.width != 32 && type.width != 64) return invalid("a number has an odd width");
      if (type.width == 8 && type.kind == Kind::kFloat) return unsupported("floats of 8 bits");
      break;
    case Op::OpTypeVector: type.kind = Kind::kVector; REPRISE_TRY(makeRow(type, operands, operand(1))); break;
    case Op::OpTypeMatrix: type.kind = Kind::kMatrix; REPRISE_TRY(makeRow(type, operands, operand(1))); break;
    case Op::OpTypeRuntimeArray: type.kind = Kind::kRuntimeArray; REPRISE_TRY(makeRow(type, operands, 0)); break;
    case Op::OpTypeArray: {
      type.kind = Kind::kArray;
      REPRISE_ASSIGN(const std::uint64_t length, constantLength(program_, operand(1)));
      REPRISE_TRY(makeRow(type, operands, length));
      break;
    }
    case Op::OpTypeStruct: type.kind = Kind::kStruct; REPRISE_TRY(defineStruct(type, result, operands)); break;
    case Op::OpTypePointer:
      type.kind = Kind::kPointer, type.flat = 1, type.storage = static_cast<spv::StorageClass>(operand(0));
      if (typeAt(operands, 1, type.element) == nullptr) return unsupported("pointers to types that come later");
      break;
    case Op::OpTypeImage: type.kind = Kind::kImage, type.flat = 1; break;
    case Op::OpTypeSampler: type.kind = Kind::kSampler, type.flat = 1; break;
    case Op::OpTypeSampledImage: type.kind = Kind::kSampledImage, type.flat = 1; break;
    default: break;
  }
  if (type.depth > kDeepest) return unsupported("types nested so deep");
  program_.types.push_back(type);
  program_.ids[result] = {IdInfo::What::kType, number, 0, 0, 0};
  return {};
}

}  // namespace reprise::interpreter
