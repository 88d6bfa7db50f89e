// Floats: arithmetic, comparisons, products of vectors and matrices, derivatives.
#include <array>
#include <cmath>

#include "cli/check/interpreter/componentwise.h"
#include "cli/check/interpreter/conversions.h"

namespace reprise::interpreter {

using spv::Op;

namespace {

double modulo(double a, double b) { return a - b * std::floor(a / b); }

// A vector or a matrix times a scalar is what as many multiplications are.
void timesScalar(Machine& m, const Instruction& i) {
  const Type &type = m.type(i), &scalar = m.scalarType(type);
  const Scalar *a = m.operand(i, 0, type.flat), *b = m.operand(i, 1, 1);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c)
    to[c] = Operation(Op::OpFMul).take(a[c], scalar).take(*b, scalar).giving(floatOf(a[c].bits, scalar.width) * floatOf(b->bits, scalar.width), scalar.width);
}

// A sum of products over `count` pairs, `a_step` and `b_step` apart, as one operation of all of them.
Scalar sumOfProducts(Operation op, const Scalar* a, std::uint32_t a_step, const Scalar* b, std::uint32_t b_step, std::uint32_t count, const Type& scalar) {
  double sum = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    op.take(a[k * a_step], scalar).take(b[k * b_step], scalar);
    sum += floatOf(a[k * a_step].bits, scalar.width) * floatOf(b[k * b_step].bits, scalar.width);
  }
  return op.giving(sum, scalar.width);
}

void dot(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.typeOf(i, 0).flat;
  const Scalar *a = m.operand(i, 0, size), *b = m.operand(i, 1, size);
  *m.result(i, 1) = sumOfProducts(Operation(i.op), a, 1, b, 1, size, m.type(i));
}

struct Shape {
  std::uint32_t columns = 1, rows = 1;
};

Shape shapeOf(const Type& type, bool row_vector) {
  if (type.kind == Kind::kMatrix && type.count != 0) return {type.count, type.flat / type.count};
  return row_vector ? Shape{type.flat, 1} : Shape{1, type.flat};
}

// All products of matrices and vectors: each component is a row of the left times a column of the right.
void product(Machine& m, const Instruction& i) {
  const Type &left = m.typeOf(i, 0), &right = m.typeOf(i, 1), &type = m.type(i);
  const Shape a = shapeOf(left, i.op == Op::OpVectorTimesMatrix), b = shapeOf(right, false);
  if (a.columns != b.rows || std::uint64_t{a.rows} * b.columns != type.flat) return m.fail(invalid("a product of matrices that do not fit"));
  const Scalar *x = m.operand(i, 0, left.flat), *y = m.operand(i, 1, right.flat);
  Scalar* to = m.result(i, type.flat);
  m.charge(std::uint64_t{type.flat} * a.columns);
  for (std::uint32_t column = 0; column < b.columns; ++column)
    for (std::uint32_t row = 0; row < a.rows; ++row)
      to[column * a.rows + row] = sumOfProducts(Operation(i.op), x + row, a.rows, y + std::size_t{column} * b.rows, 1, a.columns, m.scalarType(type));
}

void outerProduct(Machine& m, const Instruction& i) {
  const std::uint32_t rows = m.typeOf(i, 0).flat, columns = m.typeOf(i, 1).flat;
  const Type &type = m.type(i), &scalar = m.scalarType(type);
  if (std::uint64_t{rows} * columns != type.flat) return m.fail(invalid("an outer product that does not fit"));
  const Scalar *a = m.operand(i, 0, rows), *b = m.operand(i, 1, columns);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t k = 0; k < type.flat; ++k) {
    const Scalar &x = a[k % rows], &y = b[k / rows];
    to[k] = Operation(Op::OpFMul).take(x, scalar).take(y, scalar).giving(floatOf(x.bits, scalar.width) * floatOf(y.bits, scalar.width), scalar.width);
  }
}

void derivative(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  const Rows<1> rows(m, i, 0, type.flat);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    const Operation op = rows.operation(Operation(i.op), c);
    to[c] = op.giving(m.unitOf(op.hash()), m.scalarType(type).width);
  }
}

double quantized(double value) {
  const double half = floatOf(bitsOfFloat(value, 16), 16);
  return std::fabs(half) < 6.103515625e-05 ? std::copysign(0.0, value) : half;
}

bool ordered(double a, double b) { return !std::isnan(a) && !std::isnan(b); }

Handler comparison(Op op) {
  switch (op) {
    case Op::OpFOrdEqual: return testOfFloats<2, [](double a, double b) { return a == b; }>;
    case Op::OpFUnordEqual: return testOfFloats<2, [](double a, double b) { return a == b || !ordered(a, b); }>;
    case Op::OpFOrdNotEqual: return testOfFloats<2, [](double a, double b) { return a != b && ordered(a, b); }>;
    case Op::OpFUnordNotEqual: return testOfFloats<2, [](double a, double b) { return a != b; }>;
    case Op::OpFOrdLessThan: return testOfFloats<2, [](double a, double b) { return a < b; }>;
    case Op::OpFUnordLessThan: return testOfFloats<2, [](double a, double b) { return a < b || !ordered(a, b); }>;
    case Op::OpFOrdGreaterThan: return testOfFloats<2, [](double a, double b) { return b < a; }>;
    case Op::OpFUnordGreaterThan: return testOfFloats<2, [](double a, double b) { return b < a || !ordered(a, b); }>;
    case Op::OpFOrdLessThanEqual: return testOfFloats<2, [](double a, double b) { return a <= b; }>;
    case Op::OpFUnordLessThanEqual: return testOfFloats<2, [](double a, double b) { return a <= b || !ordered(a, b); }>;
    case Op::OpFOrdGreaterThanEqual: return testOfFloats<2, [](double a, double b) { return b <= a; }>;
    case Op::OpFUnordGreaterThanEqual: return testOfFloats<2, [](double a, double b) { return b <= a || !ordered(a, b); }>;
    case Op::OpLessOrGreater: return testOfFloats<2, [](double a, double b) { return a < b || b < a; }>;
    case Op::OpOrdered: return testOfFloats<2, ordered>;
    case Op::OpUnordered: return testOfFloats<2, [](double a, double b) { return !ordered(a, b); }>;
    case Op::OpIsNan: return testOfFloats<1, [](double a) { return std::isnan(a); }>;
    case Op::OpIsInf: return testOfFloats<1, [](double a) { return std::isinf(a); }>;
    default: return nullptr;
  }
}

}  // namespace

Handler floatHandler(Op op) {
  switch (op) {
    case Op::OpFNegate: return ofFloats<1, [](double a) { return -a; }>;
    case Op::OpFAdd: return ofFloats<2, [](double a, double b) { return a + b; }>;
    case Op::OpFSub: return ofFloats<2, [](double a, double b) { return a - b; }>;
    case Op::OpFMul: return ofFloats<2, [](double a, double b) { return a * b; }>;
    case Op::OpFDiv: return ofFloats<2, [](double a, double b) { return a / b; }>;
    case Op::OpFRem: return ofFloats<2, [](double a, double b) { return std::fmod(a, b); }>;
    case Op::OpFMod: return ofFloats<2, modulo>;
    case Op::OpQuantizeToF16: return ofFloats<1, quantized>;
    case Op::OpFConvert: return ofFloats<1, [](double a) { return a; }>;
    case Op::OpVectorTimesScalar: case Op::OpMatrixTimesScalar: return timesScalar;
    case Op::OpDot: return dot;
    case Op::OpMatrixTimesVector: case Op::OpVectorTimesMatrix: case Op::OpMatrixTimesMatrix: return product;
    case Op::OpOuterProduct: return outerProduct;
    case Op::OpDPdx: case Op::OpDPdy: case Op::OpFwidth: case Op::OpDPdxFine: case Op::OpDPdyFine: case Op::OpFwidthFine:
    case Op::OpDPdxCoarse: case Op::OpDPdyCoarse: case Op::OpFwidthCoarse: return derivative;
    default: break;
  }
  if (const Handler handler = conversionHandler(op)) return handler;
  return comparison(op);
}

}  // namespace reprise::interpreter
