// Of GLSL.std.450 what packs floats into integers and unpacks them.
#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <cmath>

#include "cli/check/interpreter/extended.h"
#include "cli/check/interpreter/terms.h"

namespace reprise::interpreter {
namespace {

struct Form {
  std::uint32_t parts = 0, width = 0;  // of each part, in bits
  enum class Coding { kSigned, kUnsigned, kHalf, kBits } coding = Coding::kBits;
};

Form formOf(std::uint32_t number) {
  switch (number) {
    case GLSLstd450PackSnorm4x8: case GLSLstd450UnpackSnorm4x8: return {4, 8, Form::Coding::kSigned};
    case GLSLstd450PackUnorm4x8: case GLSLstd450UnpackUnorm4x8: return {4, 8, Form::Coding::kUnsigned};
    case GLSLstd450PackSnorm2x16: case GLSLstd450UnpackSnorm2x16: return {2, 16, Form::Coding::kSigned};
    case GLSLstd450PackUnorm2x16: case GLSLstd450UnpackUnorm2x16: return {2, 16, Form::Coding::kUnsigned};
    case GLSLstd450PackHalf2x16: case GLSLstd450UnpackHalf2x16: return {2, 16, Form::Coding::kHalf};
    default: return {2, 32, Form::Coding::kBits};
  }
}

double scaleOf(const Form& form) { return std::ldexp(1.0, static_cast<int>(form.width) - (form.coding == Form::Coding::kSigned ? 1 : 0)) - 1.0; }

std::uint64_t packed(const Form& form, double value) {
  if (form.coding == Form::Coding::kHalf) return bitsOfFloat(value, 16);
  const double low = form.coding == Form::Coding::kSigned ? -1.0 : 0.0;
  const double clamped = std::isnan(value) ? 0.0 : std::clamp(value, low, 1.0);
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::nearbyint(clamped * scaleOf(form))));
}

double unpacked(const Form& form, std::uint64_t bits) {
  if (form.coding == Form::Coding::kHalf) return floatOf(bits, 16);
  if (form.coding == Form::Coding::kUnsigned) return static_cast<double>(bits) / scaleOf(form);
  return std::max(static_cast<double>(signedOf(bits, form.width)) / scaleOf(form), -1.0);
}

void pack(Machine& m, const Instruction& i) {
  const Form form = formOf(i.operands[1]);
  const Type &from = m.typeOf(i, kFirstExtended), &scalar = m.scalarType(from);
  const Scalar* values = m.operand(i, kFirstExtended, form.parts);
  Operation op(Term::kExtended, i.operands[1]);
  op.takeAll(values, form.parts, scalar);
  std::uint64_t bits = 0;
  for (std::uint32_t part = 0; part < form.parts; ++part) {
    const std::uint64_t one = form.coding == Form::Coding::kBits ? values[part].bits : packed(form, floatOf(values[part].bits, scalar.width));
    bits |= (one & maskOf(form.width)) << (part * form.width);
  }
  const Type& type = m.type(i);
  Scalar out = op.givingInteger(bits, type.width);
  if (type.kind == Kind::kFloat) out.hash = op.hash();  // a double from two words
  *m.result(i, 1) = out;
}

void unpack(Machine& m, const Instruction& i) {
  const Form form = formOf(i.operands[1]);
  const Type &from = m.typeOf(i, kFirstExtended), &scalar = m.scalarType(m.type(i));
  const Scalar value = *m.operand(i, kFirstExtended, 1);
  Scalar* to = m.result(i, form.parts);
  for (std::uint32_t part = 0; part < form.parts; ++part) {
    const std::uint64_t bits = (value.bits >> (part * form.width)) & maskOf(form.width);
    const Operation op = Operation(Term::kExtended, i.operands[1]).with(part).take(value, from);
    to[part] = form.coding == Form::Coding::kBits ? op.givingInteger(bits, scalar.width) : op.giving(unpacked(form, bits), scalar.width);
  }
}

}  // namespace

Handler packingHandler(std::uint32_t number) {
  switch (number) {
    case GLSLstd450PackSnorm4x8: case GLSLstd450PackUnorm4x8: case GLSLstd450PackSnorm2x16: case GLSLstd450PackUnorm2x16:
    case GLSLstd450PackHalf2x16: case GLSLstd450PackDouble2x32: return pack;
    case GLSLstd450UnpackSnorm2x16: case GLSLstd450UnpackUnorm2x16: case GLSLstd450UnpackHalf2x16: case GLSLstd450UnpackSnorm4x8:
    case GLSLstd450UnpackUnorm4x8: case GLSLstd450UnpackDouble2x32: return unpack;
    default: return nullptr;
  }
}

}  // namespace reprise::interpreter
