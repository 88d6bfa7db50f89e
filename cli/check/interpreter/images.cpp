// Images: which one it is and how it is asked decide what it gives.
#include <algorithm>

#include "cli/check/interpreter/memory.h"
#include "cli/check/interpreter/terms.h"

namespace reprise::interpreter {

using spv::Op;

namespace {

Operation& takeImage(Operation& op, const Scalar& image) { return op.with(image.bits).with(image.hash); }

// Operands from `first` on, of which number `mask` is a literal that says what follows it.
Operation& takeOperands(Machine& m, const Instruction& i, std::size_t first, std::size_t mask, Operation& op) {
  for (std::size_t k = first; k < i.operands.size() && !m.failure; ++k) {
    if (k == mask) {
      op.with(i.operands[k]);
      continue;
    }
    const Type& type = m.typeOf(i, k);
    op.takeAll(m.operand(i, k, type.flat), type.flat, m.scalarType(type));
  }
  return op;
}

// Floats in [0, 1), integers from 0 to 3, all with the hash of how they came to be.
Scalar madeUp(const Machine& m, const Operation& op, const Type& scalar) {
  if (scalar.kind == Kind::kFloat) return op.giving(m.unitOf(op.hash()), scalar.width);
  Scalar value = op.givingInteger(m.smallOf(op.hash()), std::max(scalar.width, 1u));
  value.hash = op.hash();
  return value;
}

// The components of the result, each made up of the operation and its number.
void giveMadeUp(Machine& m, const Instruction& i, const Operation& op) {
  const Type& type = m.type(i);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) to[c] = madeUp(m, Operation(op).with(c), m.scalarType(type));
}

// kBefore: operands before the mask.
template <std::size_t kBefore>
void sample(Machine& m, const Instruction& i) {
  Operation op(i.op);
  takeImage(op, *m.operand(i, 0, 1));
  giveMadeUp(m, i, takeOperands(m, i, 1, kBefore, op));
}

// What was written to the image before is part of what it gives.
void readImage(Machine& m, const Instruction& i) {
  Operation op(i.op);
  const Scalar image = *m.operand(i, 0, 1);
  takeImage(op, image);
  if (const auto written = m.images.find(image.bits); written != m.images.end()) op.with(written->second);
  giveMadeUp(m, i, takeOperands(m, i, 1, 2, op));
}

void writeImage(Machine& m, const Instruction& i) {
  if (m.helper) return;
  Operation op(i.op);
  const Scalar image = *m.operand(i, 0, 1);
  takeImage(op, image);
  takeOperands(m, i, 1, 3, op);
  m.decideBy(op.givingBoolean(false));
  m.addEffect(op.hash());
  std::uint64_t& written = m.images[image.bits];
  written = mixed(written, op.hash());
  if (m.images.size() > kMostScalars) m.fail(unsupported("so many images that are written"));
}

// Small integers that are the same for all modules: sizes 8 to 64, 1 to 4 levels, 4 samples.
void query(Machine& m, const Instruction& i) {
  Operation op(Op::OpImageQuerySize);
  takeImage(op, {m.operand(i, 0, 1)->bits, 0, false});
  if (i.op == Op::OpImageQuerySizeLod) takeOperands(m, i, 1, i.operands.size(), op);
  const Type& type = m.type(i);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    const std::uint64_t small = mixed(op.hash(), c) >> 62;
    std::uint64_t value = std::uint64_t{8} << small;
    if (i.op == Op::OpImageQueryLevels) value = 1 + small;
    if (i.op == Op::OpImageQuerySamples) value = 4;
    to[c] = {value, 0, op.givingBoolean(false).undefined};
  }
}

void queryLod(Machine& m, const Instruction& i) {
  Operation op(i.op);
  takeImage(op, *m.operand(i, 0, 1));
  giveMadeUp(m, i, takeOperands(m, i, 1, i.operands.size(), op));
}

void sampledImage(Machine& m, const Instruction& i) {
  const std::uint64_t image = m.operand(i, 0, 1)->bits;
  *m.result(i, 1) = {image, m.operand(i, 1, 1)->bits, false};
}

void imageOf(Machine& m, const Instruction& i) {
  const std::uint64_t image = m.operand(i, 0, 1)->bits;
  *m.result(i, 1) = {image, 0, false};
}

}  // namespace

Handler imageHandler(Op op) {
  switch (op) {
    case Op::OpImageSampleImplicitLod: case Op::OpImageSampleExplicitLod: case Op::OpImageSampleProjImplicitLod:
    case Op::OpImageSampleProjExplicitLod: case Op::OpImageFetch: return sample<2>;
    case Op::OpImageSampleDrefImplicitLod: case Op::OpImageSampleDrefExplicitLod: case Op::OpImageSampleProjDrefImplicitLod:
    case Op::OpImageSampleProjDrefExplicitLod: case Op::OpImageGather: case Op::OpImageDrefGather: return sample<3>;
    case Op::OpImageRead: return readImage;
    case Op::OpImageWrite: return writeImage;
    case Op::OpImageQuerySize: case Op::OpImageQuerySizeLod: case Op::OpImageQueryLevels: case Op::OpImageQuerySamples: return query;
    case Op::OpImageQueryLod: return queryLod;
    case Op::OpSampledImage: return sampledImage;
    case Op::OpImage: return imageOf;
    default: return nullptr;
  }
}

}  // namespace reprise::interpreter
