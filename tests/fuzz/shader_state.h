// What is known while a random shader is written: the types, the variables in scope, the functions so far, and what all of it may cost.
#pragma once

#include <optional>

#include "tests/fuzz/random_shader.h"
#include "tests/fuzz/seeded_random.h"
#include "tests/fuzz/shader_types.h"

namespace reprise {

struct Variable {
  std::string name;
  int type = 0;
  bool writable = false;
  int weight = 1;       // how likely it is taken
  int below = 0;        // counters of loops: they are smaller than this; 0: nothing is known
  bool hidden = false;  // not taken at present
  bool spared = false;  // nor touched where hidden ones are
};

struct Parameter {
  std::string way;  // "in", "inout", "out"
  int type = 0;
  std::string name;
};

constexpr int kNothing = -1;  // the result of a function that gives none

struct MadeFunction {
  std::string name;
  int result = kNothing;
  std::vector<Parameter> parameters;
  int cost = 1;  // statements that a call executes, at most
};

struct ShaderState {
  SeededRandom random;
  RandomShaderOptions options;
  TypeTable types;
  std::vector<Variable> variables;  // in scope
  std::vector<MadeFunction> functions;
  int times = 1;  // how often the statement that is being written may be executed in a call
  int cost = 0;   // of the function that is being written
  int names = 0;

  ShaderState(std::uint64_t seed, const RandomShaderOptions& how) : random(seed), options(how) {}

  std::string name(const std::string& start) { return start + std::to_string(names++); }
  bool affords(int executions) const { return cost + times * executions <= options.most_steps; }
};

// The scope of variables that are added while it lives.
class ScopeOf {
 public:
  explicit ScopeOf(ShaderState& state) : state_(state), size_(state.variables.size()) {}
  ~ScopeOf() { state_.variables.resize(size_); }
  ScopeOf(const ScopeOf&) = delete;
  ScopeOf& operator=(const ScopeOf&) = delete;

 private:
  ShaderState& state_;
  std::size_t size_;
};

}  // namespace reprise
