// Pixels in which a derivative or an implicit level of detail is undefined: lanes of their quad took different ways to it. What a device
// makes of it there may change with anything around, so that a difference says nothing.
//
// They are found by a copy of the prepared shader that keeps a trace of the branches that lead to such derivatives, and whose colour tells
// where neighbours' traces differ. It is a mask and no reference.
#pragma once

#include <string>
#include <vector>

#include "compiler/strategies/shader_program.h"
#include "profiler/harness/harness.h"

namespace reprise {

struct DivergentPlay {
  const Context& context;
  Commands& commands;
  const ShaderProgram& program;  // of harnessProgram
  HarnessOptions options;
};

// By frame and pixel, for frames 0 up to `frames`, as the harness plays the original; empty where no derivative can be reached by parted lanes.
// Errors: variable.use (kRefused), those of Harness.
Result<std::vector<std::vector<bool>>> divergentQuads(const DivergentPlay& play, int frames);

// For a verdict: "" where no derivative can be reached by parted lanes, else what was left out, and where the first of them stands.
std::string divergenceNote(const ShaderProgram& program, const std::vector<std::vector<bool>>& divergent);

}  // namespace reprise
