// Expressions of random shaders. A depth is how many more levels an expression may nest; at 0 it is a variable or a literal.
#pragma once

#include "tests/fuzz/shader_state.h"

namespace reprise {

class ShaderValues {
 public:
  explicit ShaderValues(ShaderState& state) : state_(state), random_(state.random) {}

  // Of any type of the table. Integers are any, floats finite where variables are.
  std::string value(int type, int depth);
  // Like value, with floats of at most 2: what variables are given, so that they stay finite however often it is done.
  std::string bounded(int type, int depth);
  // From 0 to count - 1.
  std::string index(int count, int depth);
  // A part of a variable, of the type `wanted`: a place to write, or one to read. Nothing where no variable has one.
  std::optional<std::string> place(int wanted, bool writable, int depth);
  // From a value of `type`, written `start`, to a part of it.
  std::string pathTo(const std::string& start, int type, int wanted, int depth);
  // Nothing where an argument is lacking or the call costs too much.
  std::optional<std::string> call(const MadeFunction& function, int depth);
  // A literal of the type, made of literals.
  std::string literal(int type);

 private:
  std::string boolean(int depth);
  std::string integer(int depth);
  std::string real(int depth);
  std::string smallReal(int depth);  // at most 1
  std::string vector(int type, int depth);
  std::string aggregate(int type, int depth, bool literals);
  std::string comparison(int depth);
  std::optional<std::string> callOf(int type, int depth);

  ShaderState& state_;
  SeededRandom& random_;
};

}  // namespace reprise
