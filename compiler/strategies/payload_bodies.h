// The user's fragment shader as the bodies that frames call: with the payload given (hit), and handing it out (miss).
#pragma once

#include <cstdint>

#include "compiler/strategies/shader_program.h"
#include "compiler/strategies/strategy.h"

namespace reprise {

struct PayloadBodies {
  Module module;                       // its entry points are the bodies asked for
  std::uint32_t hit = 0, miss = 0;     // function ids; 0: not asked for
  std::uint32_t payload_variable = 0;  // vec4, or uvec4 for integers
  std::uint32_t valid_variable = 0;    // uint; an interface variable cannot be bool
};

// value 0: no payload (a depth prepass asks for the miss body alone). Errors: variable.use (kRefused), spirv.optimize.
Result<PayloadBodies> makeBodies(const PreparedShader& shader, std::uint32_t value, const Bodies& wanted);

}  // namespace reprise
