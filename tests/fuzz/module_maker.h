// A fragment module put together instruction by instruction, for modules that no compiler would make.
#pragma once

#include <string>

#include "compiler/ir/globals.h"

namespace reprise {

class ModuleMaker {
 public:
  ModuleMaker();

  std::uint32_t real() const { return real_; }
  std::uint32_t boolean() const { return boolean_; }
  std::uint32_t x() const { return x_; }            // a varying's value in main's first block
  std::uint32_t condition() const { return condition_; }  // of x
  Module& module() { return module_; }

  std::uint32_t id() { return module_.freshId(); }
  std::uint32_t constant(float value) { return floatConstant(module_, value); }
  // A new global without a look for its like, which would be quadratic.
  std::uint32_t global(spv::Op opcode, std::uint32_t type, std::vector<Operand> operands);
  std::uint32_t varying(std::uint32_t location);
  std::uint32_t localVariable(std::uint32_t type);

  // Appends to the open block; the result's id, 0 where there is none.
  std::uint32_t add(spv::Op opcode, std::uint32_t type, std::vector<Operand> operands);
  void end(spv::Op opcode, std::vector<Operand> operands = {}) { add(opcode, 0, std::move(operands)); }
  std::uint32_t sum(std::uint32_t a, std::uint32_t b) { return add(spv::Op::OpFAdd, real_, {idOperand(a), idOperand(b)}); }
  void begin(std::uint32_t label);
  // A function float f(float) with one open block; returns its id. main is the first.
  std::uint32_t beginFunction(std::uint32_t* parameter);

  // Stores `value` to the colour output, returns, and gives the module's words.
  std::vector<std::uint32_t> finish(std::uint32_t value);
  // Goes on with main after other functions.
  void resumeMain() { current_ = 0; }

 private:
  Module module_;
  std::size_t current_ = 0;  // function
  std::uint32_t void_ = 0, real_ = 0, boolean_ = 0, color_ = 0, input_pointer_ = 0, x_ = 0, condition_ = 0, function_type_ = 0;
};

}  // namespace reprise
