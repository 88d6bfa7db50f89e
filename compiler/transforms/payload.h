// The two halves of caching a value: a function that takes it from outside, and one that hands it out.
//
// The payload travels in a vec4 variable whatever its type: a float in x, a vec2 in xy, a vec3 in xyz; the rest is 0.
// 16-bit floats are widened; integers travel in a uvec4 by their bits, booleans there as 0 and 1.
#pragma once

#include <cstdint>

#include "compiler/ir/module.h"

namespace reprise {

struct PayloadPlace {
  std::uint32_t function = 0;
  std::uint32_t value = 0;              // result id in that function, of a payload type (payload_type.h)
  std::uint32_t payload_variable = 0;   // of payloadVectorType, any storage class that may be loaded and stored
  std::uint32_t valid_variable = 0;     // uint; exportPayload stores 1
};

// The type of the payload variable for values of this type: vec4 or uvec4.
std::uint32_t payloadVectorType(Module& module, std::uint32_t value_type);

// The value is loaded from the payload variable where it was computed; its computation stays behind as dead code.
Module substitutePayload(const Module& module, const PayloadPlace& place);

// Right after the value is computed it is stored to the payload variable, unencoded, and the valid variable is set.
Module exportPayload(const Module& module, const PayloadPlace& place);

}  // namespace reprise
