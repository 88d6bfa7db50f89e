#include "compiler/ir/payload_type.h"

#include <optional>

namespace reprise {
namespace {

using spv::Op;

std::optional<PayloadScalar> scalarOf(const Instruction& type) {
  if (type.opcode == Op::OpTypeBool) return PayloadScalar::kBool;
  if (type.opcode == Op::OpTypeInt && type.word(0) == 32)
    return type.word(1) != 0 ? PayloadScalar::kInt : PayloadScalar::kUint;
  if (type.opcode == Op::OpTypeFloat && type.word(0) == 32) return PayloadScalar::kFloat;
  if (type.opcode == Op::OpTypeFloat && type.word(0) == 16) return PayloadScalar::kHalf;
  return std::nullopt;
}

}  // namespace

PayloadType payloadType(const Module& module, std::uint32_t type_id) {
  const Instruction* type = findGlobal(module, type_id);
  if (type == nullptr) return {};
  const bool is_vector = type->opcode == Op::OpTypeVector;
  const auto scalar = scalarOf(is_vector ? *findGlobal(module, type->word(0)) : *type);
  const int channels = is_vector ? static_cast<int>(type->word(1)) : 1;
  if (!scalar || channels > 4) return {};
  return {*scalar, channels};
}

std::string nameOf(const PayloadType& type) {
  struct Spelling {
    const char *scalar, *vector;
  };
  constexpr Spelling kSpellings[] = {
      {"float", "vec"}, {"float16_t", "f16vec"}, {"int", "ivec"}, {"uint", "uvec"}, {"bool", "bvec"}};
  const Spelling& spelling = kSpellings[static_cast<int>(type.scalar)];
  return type.channels == 1 ? spelling.scalar : spelling.vector + std::to_string(type.channels);
}

bool isInteger(PayloadScalar scalar) {
  return scalar != PayloadScalar::kFloat && scalar != PayloadScalar::kHalf;
}

}  // namespace reprise
