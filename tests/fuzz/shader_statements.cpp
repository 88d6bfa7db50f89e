#include "tests/fuzz/shader_statements.h"

#include <algorithm>
#include <array>

namespace reprise {

namespace {

constexpr int kCarriedWeight = 8, kLocalWeight = 3;

}  // namespace

void ShaderStatements::line(const std::string& text) {
  text_ += std::string(static_cast<std::size_t>(indent_) * 2, ' ') + text + "\n";
}

void ShaderStatements::declare(int type, const std::string& start, int weight) {
  const std::string value = random_.chance(30) ? values_.literal(type) : values_.bounded(type, 2);
  const std::string name = state_.name(start);
  line(state_.types[type].name + " " + name + " = " + value + ";");
  state_.variables.push_back({name, type, true, weight});
  state_.cost += state_.times;
}

void ShaderStatements::declareCarried(std::pair<int, int> integers, std::pair<int, int> reals) {
  for (int left = random_.between(integers.first, integers.second); left > 0; --left) declare(kInt, "a", kCarriedWeight);
  for (int left = random_.between(reals.first, reals.second); left > 0; --left) declare(kFloat, "w", kCarriedWeight / 2);
}

int ShaderStatements::size(const Surroundings& at) {
  return random_.between(1, std::max(2, state_.options.statements / std::max(1, at.depth)));
}

void ShaderStatements::block(int statements, const Surroundings& at) {
  const ScopeOf scope(state_);
  for (int i = 0; i < statements; ++i) statement(at);
}

void ShaderStatements::statement(const Surroundings& at) {
  state_.cost += state_.times;
  const bool nests = at.depth < state_.options.depth;
  const int branches = !nests ? 0 : at.continues ? 30 : 14, loops = !nests ? 0 : at.continues ? 22 : 20;
  const std::array<int, 10> weights = {12, 14, 10, 8, 5, branches, loops, nests ? 6 : 0, 6, at.continues ? 8 : at.is_main ? 1 : 4};
  switch (random_.weighted(weights)) {
    case 0: return assign();
    case 1: return copy();
    case 2: return compound();
    case 3: return assignPart();
    case 4: return declare(random_.chance(60) ? kInt : random_.below(kVec4 + 1), "t", kLocalWeight);
    case 5: return branch(at);
    case 6: return loop(at);
    case 7: return switchOver(at);
    case 8: return callStatement();
    default: jumpIf(at);
  }
}

void ShaderStatements::jumpIf(const Surroundings& at) {
  if (at.is_main && random_.chance(6)) return line("if (" + values_.value(kBool, 2) + ") discard;");
  line("if (" + values_.value(kBool, 2) + ") {");
  ++indent_;
  jump(at);
  --indent_;
  line("}");
}

void ShaderStatements::assign() {
  const int type = random_.chance(50) ? kInt : random_.chance(60) ? kFloat : random_.below(kVec4 + 1);
  const std::optional<std::string> place = values_.place(type, true, 2);
  if (place) line(*place + " = " + values_.bounded(type, state_.options.value_depth) + ";");
}

// A variable that takes another one's value as it is: what promotion to SSA makes of this is a value with two names.
void ShaderStatements::copy() {
  const int type = random_.chance(70) ? kInt : random_.below(state_.types.size());
  const std::optional<std::string> to = values_.place(type, true, 1), from = values_.place(type, false, 1);
  if (to && from && *to != *from) line(*to + " = " + *from + ";");
}

void ShaderStatements::compound() {
  const bool integer = random_.chance(55);
  const std::optional<std::string> place = values_.place(integer ? kInt : kFloat, true, 1);
  if (place) compoundOf(*place, integer);
}

void ShaderStatements::compoundOf(const std::string& place, bool integer) {
  static const std::array<const char*, 6> kIntegers = {" += ", " -= ", " |= ", " ^= ", " &= ", " *= "};
  if (integer && random_.chance(25)) return line("++" + place + ";");
  if (!integer && random_.chance(40)) return line(place + " *= " + (random_.chance(50) ? "0.5" : "sin(" + values_.value(kFloat, 1) + ")") + ";");
  const std::string step = integer ? random_.of(kIntegers) : random_.chance(70) ? " += " : " -= ";
  line(place + step + (integer ? values_.value(kInt, 1) : values_.bounded(kFloat, 2)) + ";");
}

// A part of a structure, an array, the matrix or a vector.
void ShaderStatements::assignPart() {
  std::vector<Variable> wholes;
  for (const Variable& variable : state_.variables)
    if (variable.writable && variable.type >= kVec2) wholes.push_back(variable);
  if (wholes.empty()) return assign();
  const Variable whole = random_.of(wholes);
  std::vector<int> parts;
  for (int type = 0; type < state_.types.size(); ++type)
    if (state_.types.reaches(whole.type, type)) parts.push_back(type);
  const int type = random_.of(parts);
  const std::string part = values_.pathTo(whole.name, whole.type, type, 2);
  const bool steps = (type == kInt || type == kFloat) && random_.chance(40);
  line(part + (steps ? " += " : " = ") + values_.bounded(type, 2) + ";");
}

void ShaderStatements::callStatement() {
  if (state_.functions.empty()) return assign();
  const MadeFunction function = random_.of(state_.functions);
  std::optional<std::string> place;
  if (function.result != kNothing && random_.chance(80)) place = values_.place(function.result, true, 1);
  const std::optional<std::string> called = values_.call(function, 2);
  if (called) line((place ? *place + " = " : "") + *called + ";");
}

void ShaderStatements::branch(const Surroundings& at) {
  Surroundings inside = at;
  ++inside.depth;
  const auto part = [&] {
    ++indent_;
    const ScopeOf scope(state_);
    touch(at);
    if (at.continues && inside.depth < state_.options.depth && random_.chance(30)) loop(inside);
    block(size(inside), inside);
    touch(at);
    if (random_.chance(at.continues ? 35 : at.is_main ? 2 : 8)) jump(inside);
    --indent_;
  };
  line("if (" + values_.value(kBool, random_.between(1, 2)) + ") {");
  part();
  if (random_.chance(15)) {
    line("} else if (" + values_.value(kBool, 2) + ") {");
    part();
  }
  if (random_.chance(60)) {
    line("} else {");
    part();
  }
  line("}");
}

void ShaderStatements::returnStatement(const Surroundings& at) {
  if (at.is_main) {
    line("color = " + values_.value(kVec4, 1) + ";");
    return line("return;");
  }
  line(at.result == kNothing ? "return;" : "return " + values_.bounded(at.result, 2) + ";");
}

// Out of a loop or switch, to a loop's next turn, or out of the function.
void ShaderStatements::jump(const Surroundings& at) {
  const std::array<int, 3> weights = {at.breaks ? 10 : 0, at.continues ? 10 : 0, at.is_main ? 1 : at.continues ? 7 : 4};
  switch (random_.weighted(weights)) {
    case 0: line("break;"); break;
    case 1: line("continue;"); break;
    default: returnStatement(at);
  }
  // Code that nothing reaches is allowed.
  if (random_.chance(4)) compound();
}

std::string ShaderStatements::bound(int most) {
  const std::string limit = std::to_string(most);
  switch (random_.below(5)) {
    case 0: return limit;
    case 1: return "min(" + values_.value(kInt, 1) + ", " + limit + ")";
    case 2: return "int(" + std::to_string(most) + ".0 * fract(" + values_.value(kFloat, 0) + "))";
    case 3: return "min((" + values_.value(kInt, 0) + " & 3) + 1, " + limit + ")";
    default: return "min(" + values_.value(kInt, 0) + " & 3, " + limit + ")";
  }
}

// Every loop works on some of the variables only.
std::vector<std::size_t> ShaderStatements::hideSome() {
  std::vector<std::size_t> hidden;
  for (std::size_t i = 0; i < state_.variables.size(); ++i) {
    Variable& variable = state_.variables[i];
    if (variable.hidden || !variable.writable || !random_.chance(40)) continue;
    variable.hidden = true;
    hidden.push_back(i);
  }
  return hidden;
}

// A scalar that is hidden, most often the first: what several loops and branches do to the same one is what may go wrong.
std::optional<std::size_t> ShaderStatements::resting() {
  std::vector<std::size_t> scalars;
  for (std::size_t i = 0; i < state_.variables.size(); ++i) {
    const Variable& variable = state_.variables[i];
    if (variable.hidden && !variable.spared && (variable.type == kInt || variable.type == kFloat)) scalars.push_back(i);
  }
  if (scalars.empty()) return std::nullopt;
  return random_.chance(70) ? scalars.front() : random_.of(scalars);
}

// Inside of a loop an arm of a branch may change what the loop otherwise leaves alone.
void ShaderStatements::touch(const Surroundings& at) {
  if (!at.continues || !random_.chance(35)) return;
  if (const std::optional<std::size_t> found = resting())
    compoundOf(state_.variables[*found].name, state_.variables[*found].type == kInt);
}

void ShaderStatements::loop(const Surroundings& at) {
  const int most = random_.between(1, 4);
  // A body of some ten statements is to be affordable.
  if (!state_.affords(most * 12)) return assign();
  const std::vector<std::size_t> hidden = hideSome();
  // What a loop leaves alone is often set before it and changed behind it; so may be what the loops around it leave alone.
  const std::optional<std::size_t> around = random_.chance(70) ? resting() : std::nullopt;
  if (around) setAround(*around);
  Surroundings inside = at;
  ++inside.depth;
  inside.breaks = inside.continues = true;
  state_.times *= most;
  loopOfForm(most, inside);
  state_.times /= most;
  for (const std::size_t i : hidden) state_.variables[i].hidden = false;
  if (!around) return;
  state_.variables[*around].spared = false;
  compoundOf(state_.variables[*around].name, state_.variables[*around].type == kInt);
}

void ShaderStatements::setAround(std::size_t variable) {
  const Variable around = state_.variables[variable];
  state_.variables[variable].spared = true;
  if (random_.chance(80)) line(around.name + " = " + values_.bounded(around.type, 1) + ";");
}

void ShaderStatements::loopOfForm(int most, const Surroundings& inside) {
  const ScopeOf scope(state_);
  if (random_.chance(50))
    countingLoop(most, inside);
  else
    guardedLoop(most, inside);
}

void ShaderStatements::loopBody(const Surroundings& inside) {
  if (random_.chance(30)) jumpIf(inside);
  block(size(inside) + 1, inside);
  if (random_.chance(4)) jump(inside);
}

void ShaderStatements::countingLoop(int most, const Surroundings& inside) {
  std::string limit = bound(most);
  if (random_.chance(50)) {
    const std::string name = state_.name("limit");
    line("int " + name + " = " + limit + ";");
    limit = name;
  }
  const std::string counter = state_.name("i");
  const std::string more = random_.chance(15) ? " && " + values_.value(kBool, 2) : "";
  const bool down = random_.chance(15);
  const std::string step = random_.chance(15) ? counter + " += 1 + (" + values_.value(kInt, 0) + " & 1)" : "++" + counter;
  line(down ? "for (int " + counter + " = " + limit + "; " + counter + "-- > 0" + more + ";) {"
            : "for (int " + counter + " = 0; " + counter + " < " + limit + more + "; " + step + ") {");
  ++indent_;
  state_.variables.push_back({counter, kInt, false, kLocalWeight, most});
  loopBody(inside);
  --indent_;
  line("}");
}

// A loop that a counter ends only in the last resort.
void ShaderStatements::guardedLoop(int most, const Surroundings& inside) {
  const std::string guard = state_.name("guard"), within = guard + " < " + std::to_string(most);
  const std::string condition = values_.value(kBool, 2);
  line("int " + guard + " = 0;");
  const int form = random_.below(4);
  if (form == 0) line("while (" + within + " && " + condition + ") {");
  if (form == 1) line("do {");
  if (form == 2) line("while (true) {");
  if (form == 3) line("for (;;) {");
  ++indent_;
  if (form >= 2) {
    line("if (" + guard + " >= " + std::to_string(most) + ") {");
    ++indent_;
    if (!inside.is_main && random_.chance(30))
      returnStatement(inside);
    else
      line("break;");
    --indent_;
    line("}");
  }
  line("++" + guard + ";");
  loopBody(inside);
  --indent_;
  line(form == 1 ? "} while (" + within + " && " + condition + ");" : "}");
}

void ShaderStatements::switchOver(const Surroundings& at) {
  Surroundings inside = at;
  ++inside.depth;
  inside.breaks = true;
  std::vector<std::string> labels;
  for (int i = 0, number = random_.below(2), count = random_.between(1, 4); i < count; ++i, number += random_.between(1, 2))
    labels.push_back("case " + std::to_string(number) + ":");
  if (random_.chance(75)) labels.insert(labels.begin() + random_.below(static_cast<int>(labels.size()) + 1), "default:");
  const std::string selector = random_.chance(6) ? values_.literal(kInt) : "(" + values_.value(kInt, 2) + ") & 3";
  line("switch (" + selector + ") {");
  ++indent_;
  for (std::size_t i = 0; i < labels.size(); ++i) switchCase(labels[i], i + 1 == labels.size(), inside);
  --indent_;
  line("}");
}

void ShaderStatements::switchCase(const std::string& label, bool last, const Surroundings& inside) {
  line(label);
  if (!last && random_.chance(10)) return;  // shares the next one's statements
  ++indent_;
  line("{");
  ++indent_;
  block(random_.between(1, 2), inside);
  touch(inside);
  if (random_.chance(15)) jump(inside);
  --indent_;
  line("}");
  if (last || random_.chance(70)) line("break;");
  --indent_;
}

}  // namespace reprise
