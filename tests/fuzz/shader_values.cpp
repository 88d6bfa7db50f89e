#include "tests/fuzz/shader_values.h"

#include <algorithm>
#include <array>

namespace reprise {

namespace {

using Texts = std::vector<std::string>;

// A braced list is evaluated from left to right, the operands of + in any order: seeds must mean the same to every compiler.
std::string joined(std::initializer_list<std::string> parts) {
  std::string text;
  for (const std::string& part : parts) text += part;
  return text;
}

const Texts kReals = {"0.0", "1.0", "0.5", "0.25", "-1.0", "0.75", "1.5", "-0.3", "0.1"};
const Texts kSwizzles2 = {".xy", ".yx", ".yz", ".zx"};
const Texts kSwizzles3 = {".xyz", ".zyx", ".yzw", ".wxz"};

}  // namespace

std::string ShaderValues::literal(int type) {
  switch (state_.types[type].kind) {
    case Kind::kBool: return random_.chance(50) ? "true" : "false";
    case Kind::kInt: return std::to_string(random_.below(8));
    case Kind::kFloat: return random_.of(kReals);
    default: return aggregate(type, 0, true);
  }
}

std::string ShaderValues::aggregate(int type, int depth, bool literals) {
  const ShaderType& shape = state_.types[type];
  const auto part = [&](int of) { return literals ? literal(of) : bounded(of, depth); };
  std::string text;
  if (shape.kind == Kind::kStruct)
    for (const Field& field : shape.fields) text += (text.empty() ? "" : ", ") + part(field.type);
  else
    for (int i = 0; i < shape.count; ++i) text += (text.empty() ? "" : ", ") + part(shape.element);
  return shape.name + "(" + text + ")";
}

std::string ShaderValues::index(int count, int depth) {
  if (random_.chance(40)) {
    std::vector<std::string> counters;
    for (const Variable& variable : state_.variables)
      if (variable.below > 0 && variable.below <= count) counters.push_back(variable.name);
    if (!counters.empty()) return random_.of(counters);
  }
  if (depth <= 0 || random_.chance(35)) return std::to_string(random_.below(count));
  const std::string any = integer(depth - 1);
  if ((count & (count - 1)) == 0) return joined({"(", any, ") & ", std::to_string(count - 1)});
  if (random_.chance(50)) return joined({"clamp(", any, ", 0, ", std::to_string(count - 1), ")"});
  return joined({"((", any, ") & 15) % ", std::to_string(count)});
}

std::string ShaderValues::pathTo(const std::string& start, int type, int wanted, int depth) {
  if (type == wanted) return start;
  const ShaderType& shape = state_.types[type];
  const bool vector = shape.kind == Kind::kVec2 || shape.kind == Kind::kVec3 || shape.kind == Kind::kVec4;
  if (vector && wanted == kFloat) {
    if (random_.chance(25)) return joined({start, "[", index(shape.count, depth - 1), "]"});
    return joined({start, ".", std::string(1, "xyzw"[random_.below(shape.count)])});
  }
  if (vector) {
    if (wanted == kVec3) return joined({start, random_.of(kSwizzles3)});
    return joined({start, (shape.kind == Kind::kVec4 || shape.kind == Kind::kVec3 ? random_.of(kSwizzles2) : "")});
  }
  if (shape.count > 0)
    return pathTo(start + "[" + index(shape.count, depth - 1) + "]", shape.element, wanted, depth);
  std::vector<Field> fields;
  for (const Field& field : shape.fields)
    if (state_.types.reaches(field.type, wanted)) fields.push_back(field);
  const Field& field = random_.of(fields);
  return pathTo(start + "." + field.name, field.type, wanted, depth);
}

std::optional<std::string> ShaderValues::place(int wanted, bool writable, int depth) {
  std::vector<int> weights;
  bool any = false;
  for (const Variable& variable : state_.variables) {
    const bool fits = !variable.hidden && (variable.writable || !writable) && state_.types.reaches(variable.type, wanted);
    weights.push_back(fits ? variable.weight : 0);
    any = any || fits;
  }
  if (!any) return std::nullopt;
  const Variable variable = state_.variables[static_cast<std::size_t>(random_.weighted(weights))];
  return pathTo(variable.name, variable.type, wanted, depth);
}

std::optional<std::string> ShaderValues::call(const MadeFunction& function, int depth) {
  if (!state_.affords(function.cost)) return std::nullopt;
  state_.cost += state_.times * function.cost;
  std::string arguments;
  for (const Parameter& parameter : function.parameters) {
    if (!arguments.empty()) arguments += ", ";
    if (parameter.way == "in") {
      arguments += value(parameter.type, depth - 1);
      continue;
    }
    const std::optional<std::string> written = place(parameter.type, true, depth);
    if (!written) return std::nullopt;
    arguments += *written;
  }
  return function.name + "(" + arguments + ")";
}

std::optional<std::string> ShaderValues::callOf(int type, int depth) {
  std::vector<std::size_t> fitting;
  for (std::size_t i = 0; i < state_.functions.size(); ++i)
    if (state_.functions[i].result == type) fitting.push_back(i);
  if (fitting.empty()) return std::nullopt;
  return call(state_.functions[random_.of(fitting)], depth);
}

std::string ShaderValues::value(int type, int depth) {
  if (depth > 0 && random_.chance(12))
    if (const std::optional<std::string> made = callOf(type, depth)) return *made;
  switch (state_.types[type].kind) {
    case Kind::kBool: return boolean(depth);
    case Kind::kInt: return integer(depth);
    case Kind::kFloat: return real(depth);
    case Kind::kVec2:
    case Kind::kVec3:
    case Kind::kVec4: return vector(type, depth);
    default: break;
  }
  if (random_.chance(70))
    if (const std::optional<std::string> other = place(type, false, depth)) return *other;
  return aggregate(type, std::min(depth - 1, 1), false);
}

std::string ShaderValues::bounded(int type, int depth) {
  if (type == kFloat) {
    switch (random_.below(5)) {
      case 0: return joined({"clamp(", value(kFloat, depth - 1), ", -2.0, 2.0)"});
      case 1: return random_.of(kReals);
      default: return smallReal(depth);
    }
  }
  const Kind kind = state_.types[type].kind;
  if (kind != Kind::kVec2 && kind != Kind::kVec3 && kind != Kind::kVec4) return value(type, depth);
  static const Texts kBounds = {"sin(", "fract(", "cos("};
  return depth <= 0 ? aggregate(type, 0, false) : joined({random_.of(kBounds), value(type, depth - 1), ")"});
}

std::string ShaderValues::comparison(int depth) {
  static const Texts kIntegers = {" == ", " != ", " < ", " > ", " <= ", " >= "};
  if (random_.chance(60)) return joined({integer(depth - 1), random_.of(kIntegers), integer(depth - 1)});
  if (random_.chance(20)) return joined({real(0), (random_.chance(50) ? " > 1e20" : " < 1e20")});  // never, always
  return joined({real(depth - 1), (random_.chance(50) ? " < " : " > "), (random_.chance(50) ? random_.of(kReals) : real(depth - 1))});
}

std::string ShaderValues::boolean(int depth) {
  if (depth <= 0 || random_.chance(10)) {
    const std::optional<std::string> variable = place(kBool, false, 0);
    if (variable && random_.chance(80)) return *variable;
    return random_.chance(15) ? literal(kBool) : "(" + comparison(1) + ")";
  }
  switch (random_.below(10)) {
    case 0: return joined({"(", boolean(depth - 1), " && ", boolean(depth - 1), ")"});
    case 1: return joined({"(", boolean(depth - 1), " || ", boolean(depth - 1), ")"});
    case 2: return joined({"!", boolean(depth - 1)});
    case 3: return joined({"(((", integer(depth - 1), ") & 1) == 0)"});
    case 4: return joined({"any(greaterThan(", vector(kVec3, depth - 1), ", vec3(", random_.of(kReals), ")))"});
    default: return joined({"(", comparison(depth), ")"});
  }
}

std::string ShaderValues::integer(int depth) {
  if (depth <= 0 || random_.chance(25)) {
    const std::optional<std::string> variable = random_.chance(80) ? place(kInt, false, depth) : std::nullopt;
    return variable ? *variable : literal(kInt);
  }
  static const Texts kOperators = {" + ", " - ", " * ", " & ", " | ", " ^ "};
  switch (random_.below(11)) {
    case 0: return joined({"(", boolean(depth - 1), " ? ", integer(depth - 1), " : ", integer(depth - 1), ")"});
    case 1: return joined({"int(4.0 * fract(", real(depth - 1), "))"});
    case 2: return joined({"min(", integer(depth - 1), ", ", integer(depth - 1), ")"});
    case 3: return joined({"((", integer(depth - 1), (random_.chance(50) ? ") << 1)" : ") >> 1)")});
    case 4: return joined({"int(uint(", integer(depth - 1), ") * 747796405u >> 28)"});
    case 5: return joined({"int(", boolean(depth - 1), ")"});
    case 6: return joined({"(~", integer(depth - 1), ")"});
    default: return joined({"(", integer(depth - 1), random_.of(kOperators), integer(depth - 1), ")"});
  }
}

std::string ShaderValues::smallReal(int depth) {
  static const Texts kBounds = {"sin(", "cos(", "fract(", "smoothstep(0.0, 1.0, "};
  if (depth <= 0) return random_.chance(50) ? "0.5" : "sin(" + real(0) + ")";
  return joined({random_.of(kBounds), real(depth - 1), ")"});
}

std::string ShaderValues::real(int depth) {
  if (depth <= 0 || random_.chance(20)) {
    const std::optional<std::string> variable = random_.chance(80) ? place(kFloat, false, depth) : std::nullopt;
    return variable ? *variable : random_.of(kReals);
  }
  switch (random_.below(13)) {
    case 0: return joined({"(", boolean(depth - 1), " ? ", real(depth - 1), " : ", real(depth - 1), ")"});
    case 1: return joined({"mix(", real(depth - 1), ", ", real(depth - 1), ", ", smallReal(depth - 1), ")"});
    case 2: return joined({"float((", integer(depth - 1), ") & 15)"});
    case 3: return joined({"sqrt(abs(", real(depth - 1), "))"});
    case 4: return joined({"exp(-abs(", real(depth - 1), "))"});
    case 5: return joined({"dot(", vector(kVec3, depth - 1), ", vec3(", smallReal(0), ", 0.3, 0.7))"});
    case 6: return joined({"max(", real(depth - 1), ", ", real(depth - 1), ")"});
    case 7: return joined({"(", real(depth - 1), " * ", smallReal(depth - 1), ")"});
    case 8: return joined({"(", real(depth - 1), " - ", real(depth - 1), ")"});
    case 9: return joined({"length(", vector(kVec2, depth - 1), ")"});
    case 10: return smallReal(depth);
    default: return joined({"(", real(depth - 1), " + ", real(depth - 1), ")"});
  }
}

std::string ShaderValues::vector(int type, int depth) {
  if (depth <= 0 || random_.chance(30))
    if (const std::optional<std::string> variable = place(type, false, depth)) return *variable;
  const std::string name = state_.types[type].name;
  if (depth <= 0) return joined({name, "(", random_.of(kReals), ")"});
  switch (random_.below(9)) {
    case 0: return joined({"mix(", vector(type, depth - 1), ", ", vector(type, depth - 1), ", ", smallReal(depth - 1), ")"});
    case 1: return joined({"(", vector(type, depth - 1), " * ", smallReal(depth - 1), ")"});
    case 2: return joined({"(", vector(type, depth - 1), " + ", vector(type, depth - 1), ")"});
    case 3: return joined({"sin(", vector(type, depth - 1), ")"});
    case 4: return joined({name, "(", real(depth - 1), ")"});
    case 5:
      if (type == kVec3)
        if (const std::optional<std::string> matrix = place(kMat3, false, depth))
          return joined({"(", *matrix, " * sin(", vector(kVec3, depth - 1), "))"});
      return joined({"fract(", vector(type, depth - 1), ")"});
    case 6:
      if (type == kVec4) return joined({"textureLod(image, ", vector(kVec2, depth - 1), ", 0.0)"});
      return joined({"abs(", vector(type, depth - 1), ")"});
    case 7: return joined({"(", boolean(depth - 1), " ? ", vector(type, depth - 1), " : ", vector(type, depth - 1), ")"});
    default: return aggregate(type, depth - 1, false);
  }
}

}  // namespace reprise
