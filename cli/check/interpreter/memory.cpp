#include "cli/check/interpreter/memory.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "cli/check/interpreter/terms.h"

namespace reprise::interpreter {

using spv::Op;

namespace {

constexpr std::uint32_t kMadeUpLength = 16;  // of runtime arrays and of unsized descriptor arrays
constexpr std::uint64_t kPushConstants = 0x7075736800000000u;

// One buffer, as far as an access needs it.
struct Buffer {
  std::uint64_t identity = 0;
  const std::vector<std::byte>* given = nullptr;
};

Buffer bufferOf(const Machine& m, const Pointer& pointer) {
  Buffer buffer{identityOf(m, pointer), nullptr};
  const Variable& variable = m.program.variables[pointer.variable];
  if (variable.storage == spv::StorageClass::PushConstant) {
    if (!m.inputs.push_constants.empty()) buffer.given = &m.inputs.push_constants;
  } else if (pointer.element == 0 && !m.inputs.blocks.empty()) {
    const auto found = m.inputs.blocks.find({variable.decorations.set.value_or(0), variable.decorations.binding.value_or(0)});
    if (found != m.inputs.blocks.end()) buffer.given = &found->second;
  }
  return buffer;
}

struct Layout {
  std::uint32_t matrix_stride = 0, component_stride = 0;
  bool row_major = false;
};

// Calls leaf(scalar type, byte offset, index of the scalar) for every scalar of a value in a buffer.
template <typename Leaf>
void walk(Machine& m, const Type& type, std::uint64_t offset, const Layout& layout, std::uint32_t& index, const Leaf& leaf) {
  const Type& element = m.program.types[type.element];
  if (type.flat == 0) return;  // a hostile array of nothing may be long
  switch (type.kind) {
    case Kind::kBool: case Kind::kInt: case Kind::kFloat: leaf(type, offset, index++); return;
    case Kind::kVector: {
      const std::uint32_t stride = layout.component_stride != 0 ? layout.component_stride : element.width / 8;
      for (std::uint32_t i = 0; i < type.count; ++i) walk(m, element, offset + std::uint64_t{i} * stride, {}, index, leaf);
      return;
    }
    case Kind::kMatrix: {
      const std::uint32_t size = m.scalarType(type).width / 8;
      const Layout column{0, layout.row_major ? layout.matrix_stride : 0, false};
      for (std::uint32_t i = 0; i < type.count; ++i)
        walk(m, element, offset + std::uint64_t{i} * (layout.row_major ? size : layout.matrix_stride), column, index, leaf);
      return;
    }
    case Kind::kArray:
      for (std::uint32_t i = 0; i < type.count; ++i) walk(m, element, offset + std::uint64_t{i} * type.array_stride, layout, index, leaf);
      return;
    case Kind::kStruct:
      for (const Member& member : type.members)
        walk(m, m.program.types[member.type], offset + member.decorations.offset,
             {member.decorations.matrix_stride, 0, member.decorations.row_major}, index, leaf);
      return;
    default: m.fail(unsupported("pointers or images in buffers"));
  }
}

std::uint64_t addressOf(const Buffer& buffer, const Type& scalar, std::uint64_t offset) {
  return mixed(mixed(termOf(Term::kBlock, buffer.identity), offset), scalar.width);
}

Scalar leafOf(const Machine& m, const Buffer& buffer, const Type& scalar, std::uint64_t offset) {
  const std::uint64_t address = addressOf(buffer, scalar, offset);
  const bool is_float = scalar.kind == Kind::kFloat;
  if (!m.stored.empty())
    if (const auto found = m.stored.find(address); found != m.stored.end()) return found->second;
  Scalar value;
  if (buffer.given != nullptr) {
    const std::size_t size = std::max(scalar.width, 8u) / 8;
    if (offset + size <= buffer.given->size()) std::memcpy(&value.bits, buffer.given->data() + offset, size);
  } else {
    value.bits = is_float ? bitsOfFloat(madeUpFloat(m, address), scalar.width) : madeUpInt(m, address, offset / 4);
  }
  if (scalar.kind == Kind::kBool) value.bits = value.bits != 0 ? 1 : 0;
  if (is_float) value.hash = address;
  return value;
}

void storeLeaf(Machine& m, const Buffer& buffer, const Type& scalar, std::uint64_t offset, Scalar value) {
  const std::uint64_t address = addressOf(buffer, scalar, offset);
  m.decideBy(value);
  m.addEffect(mixed(address, computationOf(value, scalar)));
  if (m.stored.size() >= kMostMemory) return m.fail(unsupported("buffers of which so much is written"));
  m.stored[address] = value;
}

// Of the field of four elements, whose sums are exclusive ors.
std::uint64_t timesInField(std::uint64_t a, std::uint64_t b) { return a == 0 || b == 0 ? 0 : (a + b - 2) % 3 + 1; }

Layout layoutOf(const Pointer& pointer) { return {pointer.matrix_stride, pointer.component_stride, pointer.row_major}; }

bool isHandle(const Machine& m, const Pointer& pointer) {
  return m.program.variables[pointer.variable].storage == spv::StorageClass::UniformConstant;
}

void loadHandles(Machine& m, Pointer pointer, const Type& type, Scalar* to) {
  for (std::uint32_t i = 0; i < type.flat; ++i, ++pointer.element) to[i] = {identityOf(m, pointer), 0, false};
}

std::uint32_t lengthOf(const Machine& m, const Pointer& pointer, std::uint32_t stride) {
  const Buffer buffer = bufferOf(m, pointer);
  if (buffer.given == nullptr) return kMadeUpLength;
  const std::size_t size = buffer.given->size();
  return stride == 0 || size < pointer.offset ? 0 : static_cast<std::uint32_t>((size - pointer.offset) / stride);
}

std::uint32_t clampedIndex(Machine& m, const Scalar& index, std::uint32_t width, std::uint32_t length) {
  m.decideBy(index);
  const std::int64_t wanted = signedOf(index.bits, width);
  const std::int64_t last = std::max<std::int64_t>(length, 1) - 1;
  if (wanted >= 0 && wanted <= last) return static_cast<std::uint32_t>(wanted);
  m.misbehave();
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(wanted, 0, last));
}

// One step of an access chain: `index` into `type`, which becomes the type of the part.
void step(Machine& m, Pointer& pointer, std::uint32_t& type_index, const Scalar& index, std::uint32_t width) {
  const Type& type = m.program.types[type_index];
  const bool memory = pointer.kind == PointerKind::kMemory;
  const Type& element = m.program.types[type.element];
  if (type.kind == Kind::kStruct) {
    if (index.bits >= type.members.size()) return m.fail(invalid("a structure has no such member"));
    const Member& member = type.members[index.bits];
    pointer.offset += memory ? member.first : member.decorations.offset;
    pointer.matrix_stride = member.decorations.matrix_stride, pointer.row_major = member.decorations.row_major;
    pointer.component_stride = 0;
    type_index = member.type;
    return;
  }
  if (type.kind != Kind::kArray && type.kind != Kind::kRuntimeArray && type.kind != Kind::kMatrix && type.kind != Kind::kVector)
    return m.fail(invalid("an access chain goes into a value that has no parts"));
  const bool descriptors = !memory && type.descriptor;
  std::uint32_t length = type.count;
  if (type.kind == Kind::kRuntimeArray) length = memory || descriptors ? kMadeUpLength : lengthOf(m, pointer, type.array_stride);
  const std::uint32_t at = clampedIndex(m, index, width, length);
  type_index = type.element;
  if (memory) {
    pointer.offset += at * element.flat;
  } else if (descriptors) {
    pointer.element = (pointer.element * std::max(length, 1u) + at) % kMostDescriptors;
  } else if (type.kind == Kind::kMatrix) {
    pointer.offset += at * (pointer.row_major ? m.scalarType(type).width / 8 : pointer.matrix_stride);
    pointer.component_stride = pointer.row_major ? pointer.matrix_stride : 0;
  } else if (type.kind == Kind::kVector) {
    pointer.offset += at * (pointer.component_stride != 0 ? pointer.component_stride : element.width / 8);
  } else {
    pointer.offset += at * type.array_stride;
  }
}

// The type that the pointer operand 0 points to.
std::uint32_t pointeeOf(Machine& m, const Instruction& i, std::size_t operand) {
  const Type& type = m.typeOf(i, operand);
  if (type.kind != Kind::kPointer) m.fail(invalid(nameOfInstruction(i.op) + " takes no pointer"));
  return type.element;
}

void accessChain(Machine& m, const Instruction& i) {
  std::uint32_t type = pointeeOf(m, i, 0);
  Pointer pointer = unpack(*m.operand(i, 0, 1));
  for (std::size_t k = 1; k < i.operands.size() && !m.failure; ++k) {
    const Type& of_index = m.typeOf(i, k);
    step(m, pointer, type, *m.operand(i, k, 1), of_index.width);
  }
  if (m.type(i).kind != Kind::kPointer || m.type(i).element != type) {
    // Types may be defined twice where they differ by their layout alone.
    if (m.type(i).kind != Kind::kPointer || m.program.types[m.type(i).element].flat != m.program.types[type].flat)
      return m.fail(invalid("an access chain has another type"));
  }
  *m.result(i, 1) = pack(pointer);
}

void loadValue(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  m.charge(type.flat);
  load(m, *m.operand(i, 0, 1), type, m.result(i, type.flat));
}

void storeValue(Machine& m, const Instruction& i) {
  const Type& type = m.typeOf(i, 1);
  m.charge(type.flat);
  store(m, *m.operand(i, 0, 1), type, m.operand(i, 1, type.flat));
}

void copyMemory(Machine& m, const Instruction& i) {
  const Type& type = m.program.types[pointeeOf(m, i, 1)];
  const Type& to = m.program.types[pointeeOf(m, i, 0)];
  if (m.failure || type.flat > kMostScalars || to.flat != type.flat) return m.fail(invalid("a copy between values of unlike types"));
  m.charge(type.flat);
  m.passed.assign(type.flat, {});
  load(m, *m.operand(i, 1, 1), type, m.passed.data());
  if (!m.failure) store(m, *m.operand(i, 0, 1), to, m.passed.data());
}

void arrayLength(Machine& m, const Instruction& i) {
  const Type& type = m.program.types[pointeeOf(m, i, 0)];
  Pointer pointer = unpack(*m.operand(i, 0, 1));
  const std::uint32_t member = m.word(i, 1);
  if (m.failure || pointer.kind != PointerKind::kDescriptor || member >= type.members.size()) return m.fail(invalid("the length of no array"));
  pointer.offset += type.members[member].decorations.offset;
  *m.result(i, 1) = {lengthOf(m, pointer, m.program.types[type.members[member].type].array_stride), 0, false};
}

}  // namespace

Scalar pack(const Pointer& p) {
  Scalar scalar;
  scalar.bits = (std::uint64_t{static_cast<std::uint32_t>(p.kind)} << 62) | (std::uint64_t{p.variable} << 48) | (std::uint64_t{p.element} << 32) | p.offset;
  scalar.hash = (std::uint64_t{p.component_stride} << 32) | (p.row_major ? 0x80000000u : 0u) | (p.matrix_stride & 0x7fffffffu);
  return scalar;
}

Pointer unpack(const Scalar& s) {
  Pointer p;
  p.kind = static_cast<PointerKind>(s.bits >> 62);
  p.variable = static_cast<std::uint32_t>(s.bits >> 48) & (kMostVariables - 1);
  p.element = static_cast<std::uint32_t>(s.bits >> 32) & (kMostDescriptors - 1);
  p.offset = static_cast<std::uint32_t>(s.bits);
  p.component_stride = static_cast<std::uint32_t>(s.hash >> 32);
  p.row_major = (s.hash & 0x80000000u) != 0;
  p.matrix_stride = static_cast<std::uint32_t>(s.hash) & 0x7fffffffu;
  return p;
}

std::uint64_t identityOf(const Machine& machine, const Pointer& pointer) {
  const Variable& variable = machine.program.variables[pointer.variable];
  if (variable.storage == spv::StorageClass::PushConstant) return mixed(kPushConstants, 0);
  return mixed(mixed(variable.decorations.set.value_or(0), variable.decorations.binding.value_or(0)), pointer.element);
}

double inRangeOfSeed(std::uint32_t seed, double unit) {
  switch (seed % 4) {
    case 1: return unit;
    case 2: return 2.0 * unit - 1.0;
    case 3: return 8.0 * unit;
    default: return 2.0 * unit;
  }
}

double madeUpFloat(const Machine& machine, std::uint64_t key) {
  return inRangeOfSeed(machine.inputs.seed, unitFrom(mixed(termOf(Term::kMadeUp, machine.inputs.seed), key)));
}

// Linear over the field of four elements in the two lowest digits of the seed: four seeds from a multiple of four on give all four values, and sixteen
// give all pairs of two integers whose places differ by no multiple of four.
std::uint32_t madeUpInt(const Machine& machine, std::uint64_t key, std::uint64_t place) {
  const std::uint64_t hash = mixed(termOf(Term::kMadeUp, machine.inputs.seed / 16), key) >> 32;
  const std::uint64_t low = machine.inputs.seed & 3, high = (machine.inputs.seed >> 2) & 3;
  return static_cast<std::uint32_t>((hash & 3) ^ low ^ timesInField(high, place & 3));
}

void load(Machine& machine, const Scalar& scalar, const Type& type, Scalar* to) {
  machine.decideBy(scalar);
  const Pointer pointer = unpack(scalar);
  if (pointer.kind == PointerKind::kMemory) {
    if (pointer.offset + std::size_t{type.flat} > machine.memory.size()) return machine.fail(invalid("a load from no variable"));
    std::copy_n(machine.memory.begin() + pointer.offset, type.flat, to);
  } else if (pointer.kind != PointerKind::kDescriptor || pointer.variable >= machine.program.variables.size()) {
    machine.fail(invalid("a load from no variable"));
  } else if (isHandle(machine, pointer)) {
    loadHandles(machine, pointer, type, to);
  } else {
    const Buffer buffer = bufferOf(machine, pointer);
    std::uint32_t index = 0;
    walk(machine, type, pointer.offset, layoutOf(pointer), index,
         [&](const Type& leaf, std::uint64_t offset, std::uint32_t at) { to[at] = leafOf(machine, buffer, leaf, offset); });
  }
}

void store(Machine& machine, const Scalar& scalar, const Type& type, const Scalar* from) {
  machine.decideBy(scalar);
  const Pointer pointer = unpack(scalar);
  if (pointer.kind == PointerKind::kMemory) {
    if (pointer.offset + std::size_t{type.flat} > machine.memory.size()) return machine.fail(invalid("a store to no variable"));
    std::copy_n(from, type.flat, machine.memory.begin() + pointer.offset);
  } else if (pointer.kind != PointerKind::kDescriptor || pointer.variable >= machine.program.variables.size() || isHandle(machine, pointer)) {
    machine.fail(invalid("a store to no variable"));
  } else if (!machine.helper) {
    const Buffer buffer = bufferOf(machine, pointer);
    std::uint32_t index = 0;
    walk(machine, type, pointer.offset, layoutOf(pointer), index,
         [&](const Type& leaf, std::uint64_t offset, std::uint32_t at) { storeLeaf(machine, buffer, leaf, offset, from[at]); });
  }
}

Handler memoryHandler(Op op) {
  switch (op) {
    case Op::OpLoad: return loadValue;
    case Op::OpStore: return storeValue;
    case Op::OpCopyMemory: return copyMemory;
    case Op::OpAccessChain: case Op::OpInBoundsAccessChain: return accessChain;
    case Op::OpArrayLength: return arrayLength;
    default: return nullptr;
  }
}

}  // namespace reprise::interpreter
