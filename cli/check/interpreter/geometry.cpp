// Of GLSL.std.450 what takes whole vectors and matrices, and what interpolates varyings elsewhere.
#include <spirv/unified1/GLSL.std.450.h>

#include <array>
#include <cmath>

#include "cli/check/interpreter/extended.h"
#include "cli/check/interpreter/terms.h"

namespace reprise::interpreter {
namespace {

constexpr std::uint32_t kMostComponents = 16;
using Numbers = std::array<double, kMostComponents>;

// All operands of an instruction, as one operation of all their components.
struct Whole {
  Operation operation;
  std::array<Numbers, 3> numbers{};
  std::array<std::uint32_t, 3> sizes{};

  Whole(Machine& m, const Instruction& i) : operation(Term::kExtended, i.operands[1]) {
    for (std::size_t k = 0; k < 3 && kFirstExtended + k < i.operands.size(); ++k) {
      const Type& type = m.typeOf(i, kFirstExtended + k);
      if (type.flat > kMostComponents) {
        m.fail(invalid("a vector of too many components"));
        return;
      }
      const Scalar* values = m.operand(i, kFirstExtended + k, type.flat);
      sizes[k] = type.flat;
      operation.takeAll(values, type.flat, m.scalarType(type));
      for (std::uint32_t c = 0; c < type.flat; ++c) numbers[k][c] = floatOf(values[c].bits, m.scalarType(type).width);
    }
  }

  void give(Machine& m, const Instruction& i, const Numbers& results) const {
    const Type& type = m.type(i);
    if (type.flat > kMostComponents) return m.fail(invalid("a vector of too many components"));
    Scalar* to = m.result(i, type.flat);
    for (std::uint32_t c = 0; c < type.flat; ++c) to[c] = Operation(operation).with(c).giving(results[c], m.scalarType(type).width);
  }
};

double dotOf(const Numbers& a, const Numbers& b) {
  double sum = 0;
  for (std::uint32_t c = 0; c < 4; ++c) sum += a[c] * b[c];
  return sum;
}

template <typename Each>
Numbers made(const Each& each) {
  Numbers numbers{};
  for (std::uint32_t c = 0; c < 4; ++c) numbers[c] = each(c);
  return numbers;
}

// Of a square matrix of n columns, by elimination; `inverse` becomes its inverse.
double determinantOf(Numbers matrix, std::uint32_t n, Numbers& inverse) {
  inverse = {};
  for (std::uint32_t c = 0; c < n; ++c) inverse[c * n + c] = 1.0;
  double determinant = 1.0;
  for (std::uint32_t c = 0; c < n; ++c) {
    std::uint32_t pivot = c;
    for (std::uint32_t k = c + 1; k < n; ++k)
      if (std::fabs(matrix[k * n + c]) > std::fabs(matrix[pivot * n + c])) pivot = k;
    for (std::uint32_t k = 0; k < n && pivot != c; ++k) {
      std::swap(matrix[c * n + k], matrix[pivot * n + k]);
      std::swap(inverse[c * n + k], inverse[pivot * n + k]);
    }
    const double head = matrix[c * n + c];
    determinant *= pivot != c ? -head : head;
    for (std::uint32_t k = 0; k < n; ++k) matrix[c * n + k] /= head, inverse[c * n + k] /= head;
    for (std::uint32_t other = 0; other < n; ++other) {
      const double factor = matrix[other * n + c];
      for (std::uint32_t k = 0; k < n && other != c; ++k) matrix[other * n + k] -= factor * matrix[c * n + k], inverse[other * n + k] -= factor * inverse[c * n + k];
    }
  }
  return determinant;
}

Numbers refracted(const Numbers& along, const Numbers& normal, double ratio) {
  const double cosine = dotOf(normal, along), k = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
  if (k < 0.0) return {};
  return made([&](std::uint32_t c) { return ratio * along[c] - (ratio * cosine + std::sqrt(k)) * normal[c]; });
}

Numbers resultOf(std::uint32_t number, const Whole& whole) {
  const auto& [a, b, third] = whole.numbers;
  Numbers inverse{};
  switch (number) {
    case GLSLstd450Length: return {std::sqrt(dotOf(a, a))};
    case GLSLstd450Distance: {
      const Numbers between = made([&](std::uint32_t c) { return whole.numbers[0][c] - whole.numbers[1][c]; });
      return {std::sqrt(dotOf(between, between))};
    }
    case GLSLstd450Cross: return {a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0], a[0] * b[1] - b[0] * a[1]};
    case GLSLstd450Normalize: return made([&](std::uint32_t c) { return whole.numbers[0][c] / std::sqrt(dotOf(whole.numbers[0], whole.numbers[0])); });
    case GLSLstd450FaceForward: return made([&](std::uint32_t c) { return dotOf(whole.numbers[2], whole.numbers[1]) < 0.0 ? whole.numbers[0][c] : -whole.numbers[0][c]; });
    case GLSLstd450Reflect: return made([&](std::uint32_t c) { return whole.numbers[0][c] - 2.0 * dotOf(whole.numbers[1], whole.numbers[0]) * whole.numbers[1][c]; });
    case GLSLstd450Refract: return refracted(a, b, third[0]);
    case GLSLstd450Determinant: return {determinantOf(a, whole.sizes[0] == 4 ? 2 : whole.sizes[0] == 9 ? 3 : 4, inverse)};
    default: determinantOf(a, whole.sizes[0] == 4 ? 2 : whole.sizes[0] == 9 ? 3 : 4, inverse); return inverse;
  }
}

void geometry(Machine& m, const Instruction& i) {
  const Whole whole(m, i);
  if (!m.failure) whole.give(m, i, resultOf(i.operands[1], whole));
}

// What comes of a varying elsewhere is made up: of the varying and of where.
void interpolate(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  std::array<Scalar, 4> varying;
  if (type.flat > varying.size()) return m.fail(invalid("a vector of too many components"));
  load(m, *m.operand(i, kFirstExtended, 1), type, varying.data());
  Operation place(Term::kExtended, i.operands[1]);
  if (i.operands.size() > kFirstExtended + 1) {
    const Type& where = m.typeOf(i, kFirstExtended + 1);
    place.takeAll(m.operand(i, kFirstExtended + 1, where.flat), where.flat, m.scalarType(where));
  }
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    const Operation op = Operation(place).take(varying[c], m.scalarType(type));
    to[c] = op.giving(m.unitOf(op.hash()), m.scalarType(type).width);
  }
}

}  // namespace

Handler geometryHandler(std::uint32_t number) {
  switch (number) {
    case GLSLstd450Length: case GLSLstd450Distance: case GLSLstd450Cross: case GLSLstd450Normalize: case GLSLstd450FaceForward:
    case GLSLstd450Reflect: case GLSLstd450Refract: case GLSLstd450Determinant: case GLSLstd450MatrixInverse: return geometry;
    case GLSLstd450InterpolateAtCentroid: case GLSLstd450InterpolateAtSample: case GLSLstd450InterpolateAtOffset: return interpolate;
    default: return nullptr;
  }
}

}  // namespace reprise::interpreter
