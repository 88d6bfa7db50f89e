// The user's fragment shader as the bodies that frames call: with the payload given (hit), handing it out (miss), and telling
// which guarded values it needs (wants).
#pragma once

#include <cstdint>
#include <span>

#include "compiler/candidates/enumerate.h"
#include "compiler/strategies/shader_program.h"
#include "compiler/strategies/strategy.h"

namespace reprise {

struct PayloadBodies {
  Module module;                       // its entry points are the bodies asked for
  std::uint32_t hit = 0, miss = 0, wants = 0;  // function ids; 0: not asked for
  std::uint32_t payload_variable = 0;  // an array of vec4 (uvec4 for integers) with an element per target
  std::uint32_t wanted_variable = 0;   // uint, a bit per channel that is a guard; 0: wants was not asked for
};

// No values: no payload (a depth prepass asks for the miss body alone). Errors: variable.use (kRefused), spirv.optimize.
Result<PayloadBodies> makeBodies(const PreparedShader& shader, std::span<const CandidateValue> values, const Bodies& wanted);

}  // namespace reprise
