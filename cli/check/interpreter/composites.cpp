// Constants, composites, copies and selects: they move scalars about and leave no trace in a hash.
#include <algorithm>

#include "cli/check/interpreter/machine.h"

namespace reprise::interpreter {

using spv::Op;

namespace {

constexpr std::uint32_t kUndefinedComponent = 0xffffffff;

void constantNumber(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  std::uint64_t bits = m.word(i, 0);
  if (type.width == 64) bits |= std::uint64_t{m.word(i, 1)} << 32;
  bits &= maskOf(std::max(type.width, 1u));
  *m.result(i, 1) = {bits, type.kind == Kind::kFloat ? hashOfBits(bits, type.width) : 0, false};
}

void constantTrue(Machine& m, const Instruction& i) { *m.result(i, 1) = {1, 0, false}; }
void constantFalse(Machine& m, const Instruction& i) { *m.result(i, 1) = {0, 0, false}; }

void undefined(Machine& m, const Instruction& i) {
  m.charge(m.type(i).flat);
  m.fillUndefined(m.type(i), m.result(i, m.type(i).flat));
}

// Zeros, which are what undefined values would be but for being defined.
void zeroOf(const Program& program, const Type& type, Scalar* to) {
  if (type.kind == Kind::kStruct) {
    for (const Member& member : type.members) zeroOf(program, program.types[member.type], to + member.first);
  } else if (type.kind == Kind::kArray || type.kind == Kind::kMatrix || type.kind == Kind::kVector) {
    const Type& element = program.types[type.element];
    for (std::uint32_t i = 0; element.flat != 0 && i < type.flat; i += element.flat) zeroOf(program, element, to + i);
  } else if (type.flat == 1) {
    *to = {0, type.kind == Kind::kFloat ? hashOfBits(0, type.width) : 0, false};
  }
}

void constantNull(Machine& m, const Instruction& i) { zeroOf(m.program, m.type(i), m.result(i, m.type(i).flat)); }

void construct(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.type(i).flat;
  Scalar* to = m.result(i, size);
  m.charge(size);
  std::uint32_t at = 0;
  for (std::size_t k = 0; k < i.operands.size(); ++k) {
    const std::uint32_t part = m.typeOf(i, k).flat;
    if (part > size - at) return m.fail(invalid("a composite is made of too much"));
    std::copy_n(m.operand(i, k, part), part, to + at);
    at += part;
  }
  if (at != size) m.fail(invalid("a composite is made of too little"));
}

// Where the part lies that literals from operand `first` on lead to, and its type.
std::uint32_t partOf(Machine& m, const Instruction& i, std::size_t first, const Type*& type) {
  std::uint32_t at = 0;
  for (std::size_t k = first; k < i.operands.size(); ++k) {
    const std::uint32_t index = i.operands[k];
    if (type->kind == Kind::kStruct && index < type->members.size()) {
      at += type->members[index].first;
      type = &m.program.types[type->members[index].type];
    } else if ((type->kind == Kind::kArray || type->kind == Kind::kMatrix || type->kind == Kind::kVector) && index < type->count) {
      type = &m.program.types[type->element];
      at += index * type->flat;
    } else {
      m.fail(invalid("a composite has no such part"));
      return 0;
    }
  }
  return at;
}

void extract(Machine& m, const Instruction& i) {
  const Type* type = &m.typeOf(i, 0);
  const Scalar* from = m.operand(i, 0, type->flat);
  const std::uint32_t at = partOf(m, i, 1, type);
  if (m.failure) return;
  m.charge(type->flat);
  std::copy_n(from + at, type->flat, m.result(i, type->flat));
}

void insert(Machine& m, const Instruction& i) {
  const Type* type = &m.typeOf(i, 1);
  const std::uint32_t size = type->flat;
  const std::uint32_t at = partOf(m, i, 2, type);
  if (m.failure || size != m.type(i).flat) return m.fail(invalid("a part is put into another type"));
  m.charge(size);
  Scalar* to = m.result(i, size);
  std::copy_n(m.operand(i, 1, size), size, to);
  std::copy_n(m.operand(i, 0, type->flat), type->flat, to + at);
}

void shuffle(Machine& m, const Instruction& i) {
  const std::uint32_t left = m.typeOf(i, 0).flat, right = m.typeOf(i, 1).flat;
  const Type& type = m.type(i);
  const Scalar *a = m.operand(i, 0, left), *b = m.operand(i, 1, right);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t k = 0; k < type.flat && !m.failure; ++k) {
    const std::uint32_t from = m.word(i, 2 + k);
    if (from == kUndefinedComponent) m.fillUndefined(m.scalarType(type), to + k);
    else if (from < left) to[k] = a[from];
    else if (from - left < right) to[k] = b[from - left];
    else m.fail(invalid("a shuffle takes no component"));
  }
}

std::uint32_t componentIndex(Machine& m, const Instruction& i, std::size_t operand, std::uint32_t length) {
  const Scalar index = *m.operand(i, operand, 1);
  m.decideBy(index);
  if (index.bits < length) return static_cast<std::uint32_t>(index.bits);
  m.misbehave();
  return signedOf(index.bits, m.typeOf(i, operand).width) < 0 || length == 0 ? 0 : length - 1;
}

void extractDynamic(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.typeOf(i, 0).flat;
  const std::uint32_t at = componentIndex(m, i, 1, size);
  *m.result(i, 1) = m.operand(i, 0, std::max(size, 1u))[at];
}

void insertDynamic(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.type(i).flat;
  const std::uint32_t at = componentIndex(m, i, 2, size);
  Scalar* to = m.result(i, std::max(size, 1u));
  std::copy_n(m.operand(i, 0, size), size, to);
  to[at] = *m.operand(i, 1, 1);
}

void copy(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.type(i).flat;
  m.charge(size);
  std::copy_n(m.operand(i, 0, size), size, m.result(i, size));
}

void select(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.type(i).flat, conditions = m.typeOf(i, 0).flat;
  if (conditions != 1 && conditions < size) return m.fail(invalid("a select has too few conditions"));
  const Scalar *condition = m.operand(i, 0, conditions), *yes = m.operand(i, 1, size), *no = m.operand(i, 2, size);
  m.charge(size);
  Scalar* to = m.result(i, size);
  for (std::uint32_t k = 0; k < size; ++k) {
    const Scalar& decides = condition[conditions == 1 ? 0 : k];
    const bool undefined = decides.undefined;
    to[k] = decides.bits != 0 ? yes[k] : no[k];
    to[k].undefined = to[k].undefined || undefined;
  }
}

void transpose(Machine& m, const Instruction& i) {
  const Type &from = m.typeOf(i, 0), &type = m.type(i);
  if (from.kind != Kind::kMatrix || type.kind != Kind::kMatrix || from.flat != type.flat || from.count == 0 || type.count != from.flat / from.count)
    return m.fail(invalid("a transpose of no matrix"));
  const Scalar* a = m.operand(i, 0, from.flat);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t column = 0; column < from.count; ++column)
    for (std::uint32_t row = 0; row < type.count; ++row) to[row * from.count + column] = a[column * type.count + row];
}

}  // namespace

Handler compositeHandler(Op op) {
  switch (op) {
    case Op::OpConstant: case Op::OpSpecConstant: return constantNumber;
    case Op::OpConstantTrue: case Op::OpSpecConstantTrue: return constantTrue;
    case Op::OpConstantFalse: case Op::OpSpecConstantFalse: return constantFalse;
    case Op::OpConstantNull: return constantNull;
    case Op::OpUndef: return undefined;
    case Op::OpConstantComposite: case Op::OpSpecConstantComposite: case Op::OpCompositeConstruct: return construct;
    case Op::OpCompositeExtract: return extract;
    case Op::OpCompositeInsert: return insert;
    case Op::OpVectorShuffle: return shuffle;
    case Op::OpVectorExtractDynamic: return extractDynamic;
    case Op::OpVectorInsertDynamic: return insertDynamic;
    case Op::OpCopyObject: case Op::OpCopyLogical: return copy;
    case Op::OpExpectKHR: return copy;
    case Op::OpSelect: return select;
    case Op::OpTranspose: return transpose;
    default: return nullptr;
  }
}

}  // namespace reprise::interpreter
