#include "cli/check/interpreter/scalar.h"

#include <cmath>

namespace reprise::interpreter {
namespace {

double halfOf(std::uint64_t bits) {
  const double sign = (bits & 0x8000) != 0 ? -1.0 : 1.0;
  const int exponent = static_cast<int>((bits >> 10) & 31);
  const int mantissa = static_cast<int>(bits & 1023);
  if (exponent == 31) return mantissa != 0 ? std::nan("") : sign * HUGE_VAL;
  return exponent == 0 ? sign * std::ldexp(mantissa, -24) : sign * std::ldexp(1024 + mantissa, exponent - 25);
}

std::uint64_t bitsOfHalf(double value) {
  const std::uint64_t sign = std::signbit(value) ? 0x8000 : 0;
  if (std::isnan(value)) return sign | 0x7e00;
  const double size = std::fabs(value);
  if (size >= 65520.0) return sign | 0x7c00;
  if (size == 0.0) return sign;
  int exponent = 0;
  std::frexp(size, &exponent);
  const int step = std::max(exponent - 11, -24);  // the power of two of the last place
  const auto places = static_cast<std::uint64_t>(std::nearbyint(std::ldexp(size, -step)));
  // Subnormals have exponent 0; a carry into the next power of two comes out right by itself.
  return sign | (places + (static_cast<std::uint64_t>(step + 24) << 10));
}

}  // namespace

double floatOf(std::uint64_t bits, std::uint32_t width) {
  if (width == 32) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  return width == 64 ? std::bit_cast<double>(bits) : halfOf(bits);
}

std::uint64_t bitsOfFloat(double value, std::uint32_t width) {
  if (width == 32) return std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return width == 64 ? std::bit_cast<std::uint64_t>(value) : bitsOfHalf(value);
}

double unitFrom(std::uint64_t hash) {
  return std::ldexp(static_cast<double>(mixed(hash, 0x51) >> 40), -24);
}

}  // namespace reprise::interpreter
