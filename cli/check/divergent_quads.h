// Pixels in which a derivative or an implicit level of detail is undefined: lanes of their quad took different ways to it. What a device
// makes of it there may change with anything around, so that a difference says nothing.
//
// They are found by a copy of the prepared shader that keeps a trace of the branches that lead to such derivatives, and whose colour tells
// where neighbours' traces differ. It is a mask and no reference.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/strategies/shader_program.h"
#include "profiler/harness/harness.h"

namespace reprise {

class DivergentQuads {
 public:
  // Of a program of harnessProgram. context and commands must outlive it. Errors: variable.use (kRefused).
  static Result<DivergentQuads> create(const Context& context, Commands& commands, const ShaderProgram& program);

  // By frame and pixel, for frames 0 up to `frames`, as the harness plays the original with these inputs; empty where no derivative can be
  // reached by parted lanes. Errors: those of Harness.
  Result<std::vector<std::vector<bool>>> find(const HarnessOptions& inputs, int frames);

 private:
  DivergentQuads(const Context& context, Commands& commands) : context_(&context), commands_(&commands) {}

  const Context* context_;
  Commands* commands_;
  std::unique_ptr<const ShaderInterface> interface_;  // null where none can be found
  Package package_;
  std::optional<Player> player_;  // for whatever inputs, once it is needed
};

// For a verdict: "" where no derivative can be reached by parted lanes, else what was left out, and where the first of them stands.
std::string divergenceNote(const ShaderProgram& program, const std::vector<std::vector<bool>>& divergent);

}  // namespace reprise
