// Types whose values can be kept from frame to frame, and how a payload carries them.
//
// A payload is four channels of one kind: floats for floats, those of 16 bits widened without loss; unsigned
// integers for the rest, bit by bit, booleans as 0 and 1.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/ir/module.h"

namespace reprise {

enum class PayloadScalar { kFloat, kHalf, kInt, kUint, kBool };

struct PayloadType {
  PayloadScalar scalar = PayloadScalar::kFloat;
  int channels = 0;  // 1..4; 0: values of this type cannot be kept
};

PayloadType payloadType(const Module& module, std::uint32_t type_id);

// As GLSL calls it: "vec3", "float16_t", "ivec2", "bool".
std::string nameOf(const PayloadType& type);

// Kept bit by bit, so neither filtered nor scaled.
bool isInteger(PayloadScalar scalar);

}  // namespace reprise
