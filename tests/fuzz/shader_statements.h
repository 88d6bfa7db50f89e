// Statements of random shaders: assignments to the variables in scope, branches, loops and switches around them, and the jumps out of these.
#pragma once

#include "tests/fuzz/shader_values.h"

namespace reprise {

// Where a statement stands.
struct Surroundings {
  int depth = 0;           // of nested statements
  bool breaks = false;     // inside of a loop or switch
  bool continues = false;  // inside of a loop
  int result = kNothing;   // of the function
  bool is_main = false;
};

class ShaderStatements {
 public:
  explicit ShaderStatements(ShaderState& state) : state_(state), random_(state.random), values_(state) {}

  // Adds a line, indented.
  void line(const std::string& text);
  // Variables of the function that keep their values over its loops; least and most of each kind.
  void declareCarried(std::pair<int, int> integers, std::pair<int, int> reals);
  void declare(int type, const std::string& start, int weight);
  // About as many statements, in a scope of their own.
  void block(int statements, const Surroundings& at);
  void returnStatement(const Surroundings& at);
  void loop(const Surroundings& at);

  std::string takeText() { return std::move(text_); }
  ShaderValues& values() { return values_; }

 private:
  void statement(const Surroundings& at);
  void assign();
  void copy();
  void compound();
  void compoundOf(const std::string& place, bool integer);
  void assignPart();
  void branch(const Surroundings& at);
  void jump(const Surroundings& at);
  void jumpIf(const Surroundings& at);
  void loopOfForm(int most, const Surroundings& inside);
  std::vector<std::size_t> hideSome();
  std::optional<std::size_t> resting();
  void setAround(std::size_t variable);
  void touch(const Surroundings& at);
  void countingLoop(int most, const Surroundings& inside);
  void guardedLoop(int most, const Surroundings& inside);
  void loopBody(const Surroundings& inside);
  void switchOver(const Surroundings& at);
  void switchCase(const std::string& label, bool last, const Surroundings& inside);
  void callStatement();
  std::string bound(int most);
  int size(const Surroundings& at);

  ShaderState& state_;
  SeededRandom& random_;
  ShaderValues values_;
  std::string text_;
  int indent_ = 1;
};

}  // namespace reprise
