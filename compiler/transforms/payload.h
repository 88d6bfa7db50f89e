// The halves of caching values: a function that takes them from outside, one that hands them out, and one that tells which
// of them a pixel needs.
//
// A payload is an array of vec4, one for each target; its channels are counted through: channel c is component c % 4 of vector
// c / 4. Each value has a run of channels, which may go on in the next vector: a float one, a vec3 three. 16-bit floats are
// widened; integers travel in an array of uvec4 by their bits, booleans there as 0 and 1. A value that is computed on some paths
// only has a guard, a channel of its own that is 1 where it was computed; what is initially in the payload is the caller's.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/ir/module.h"
#include "runtime/package/recipe.h"

namespace reprise {

struct PayloadPart {
  std::uint32_t value = 0;       // result id in the function, of a payload type (payload_type.h)
  int first_channel = 0;
  int guard_channel = kNoGuard;  // parts of one block may share theirs
};

struct PayloadPlace {
  std::uint32_t function = 0;
  std::uint32_t payload_variable = 0;  // of payloadArrayType, any storage class that may be loaded and stored
  std::vector<PayloadPart> parts;      // all floats or all integers
};

// The type of the payload variable for values like this one: vec4[targets] or uvec4[targets].
std::uint32_t payloadArrayType(Module& module, std::uint32_t value_type, std::uint32_t targets);

// The values are loaded from the payload variable where they were computed; their computation stays behind as dead code.
Module substitutePayload(const Module& module, const PayloadPlace& place);

// Right after a value is computed it is stored to the payload variable, unencoded, and 1 to its guard.
Module exportPayload(const Module& module, const PayloadPlace& place);

// Where a guarded value would be computed, bit `guard_channel` of the uint variable is set. The function ends no invocation any
// more: it returns where it discarded. Guards lie in channels below 32.
Module exportWanted(const Module& module, const PayloadPlace& place, std::uint32_t wanted_variable);

}  // namespace reprise
