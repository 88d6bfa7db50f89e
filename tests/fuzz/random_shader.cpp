#include "tests/fuzz/random_shader.h"

#include "tests/fuzz/shader_statements.h"

namespace reprise {

namespace {

constexpr int kInputWeight = 3, kGlobalWeight = 3, kWholeWeight = 4;
constexpr std::size_t kMostLeaves = 12;  // of a variable

class ShaderWriter {
 public:
  ShaderWriter(std::uint64_t seed, const RandomShaderOptions& options) : state_(seed, options), statements_(state_) {
    narrow_ = random().chance(50);
  }

  std::string write() {
    makeTypes();
    std::string text = "#version 450\n" + inputs();
    text += state_.types.declare(structs_);
    text += blocks();
    text += outputs();
    text += constants();
    text += globals();
    const int count = narrow_ ? 0 : random().between(0, state_.options.functions);
    for (int i = 0; i < count; ++i) text += function();
    return text + mainFunction();
  }

 private:
  SeededRandom& random() { return state_.random; }

  void input(const std::string& name, int type) { state_.variables.push_back({name, type, false, kInputWeight}); }

  // Structures of scalars, vectors, small arrays and earlier structures.
  void makeTypes() {
    int count = random().between(1, 2);
    for (int i = 0; i < count; ++i) {
      std::vector<Field> fields = {{"tag", kInt}, {"w", kFloat}};
      for (int more = random().between(1, 3), field = 0; field < more; ++field) {
        int type = random().between(kInt, kMat3);
        const int many = random().between(2, 4);
        if (random().chance(40)) type = state_.types.arrayOf(random().between(kInt, kVec3), many);
        if (!structs_.empty() && random().chance(60))
          type = random().chance(50) ? structs_.back() : state_.types.arrayOf(structs_.back(), many);
        fields.push_back({"part" + std::to_string(field), type});
      }
      structs_.push_back(state_.types.structOf("Made" + std::to_string(i), fields));
    }
    arrays_ = {state_.types.arrayOf(kInt, random().between(2, 4)), state_.types.arrayOf(kFloat, 4),
               state_.types.arrayOf(state_.types.arrayOf(kInt, 2), 3)};
    if (random().chance(50)) arrays_.push_back(state_.types.arrayOf(structs_.front(), random().between(2, 3)));
  }

  std::string inputs() {
    input("uv", kVec2);
    input("place", kVec3);
    input("lane", kInt);
    return "layout(location = 0) in vec2 uv;\nlayout(location = 1) in vec3 place;\nlayout(location = 2) flat in int lane;\n"
           "layout(set = 0, binding = 0) uniform sampler2D image;\n";
  }

  std::string blocks() {
    const int scene = state_.types.structOf("Scene", {{"mode", kInt}, {"gain", kFloat}, {"tint", kVec4}, {"turn", kMat3},
                                                      {"lights", state_.types.arrayOf(kVec4, 4)}});
    const int draw = state_.types.structOf("Draw", {{"steps", kInt}, {"bias", kFloat}});
    input("scene", scene);
    input("draw", draw);
    // Of the endless array, the first eight.
    const int list = state_.types.arrayOf(structs_.front(), 8);
    input("memory.list", list);
    return "layout(set = 0, binding = 1) uniform Scene " + state_.types.body(scene) + " scene;\nlayout(push_constant) uniform Draw " +
           state_.types.body(draw) + " draw;\nlayout(std430, set = 0, binding = 2) readonly buffer Memory { " +
           state_.types[structs_.front()].name + " list[]; } memory;\n";
  }

  std::string outputs() {
    two_outputs_ = random().chance(35);
    return std::string("layout(location = 0) out vec4 color;\n") + (two_outputs_ ? "layout(location = 1) out ivec2 ids;\n" : "");
  }

  std::string constants() {
    if (!random().chance(40)) return "";
    const int type = random().chance(50) ? arrays_.front() : state_.types.arrayOf(kVec3, 4);
    state_.variables.push_back({"kTable", type, false, 2});
    return "const " + state_.types[type].name + " kTable = " + statements_.values().literal(type) + ";\n";
  }

  std::string globals() {
    std::string text;
    const std::vector<int> types = {kInt, kFloat, kInt, kVec3, arrays_.front(), structs_.front()};
    for (int count = narrow_ ? 0 : random().between(0, 3), i = 0; i < count; ++i) {
      const int type = random().of(types);
      const std::string name = state_.name("g");
      text += state_.types[type].name + " " + name + " = " + statements_.values().literal(type) + ";\n";
      state_.variables.push_back({name, type, true, kGlobalWeight});
    }
    return text;
  }

  // Structures and arrays of the function.
  void declareWholes(int count) {
    for (int i = 0; i < count; ++i) {
      const int type = random().chance(50) ? random().of(structs_) : random().of(arrays_);
      statements_.declare(type, "s", kWholeWeight);
    }
  }

  Parameter parameter() {
    static const std::vector<std::string> kWays = {"in", "in", "inout", "out"};
    const std::vector<int> types = {kInt, kInt, kInt, kFloat, kFloat, kVec3, kBool, structs_.front(), arrays_.front()};
    const std::string way = random().of(kWays);
    return {way, random().of(types), state_.name("p")};
  }

  // Of the scalars among the variables from `first` on: a value of the type `result` that depends on each.
  std::string summary(int result, std::size_t first) {
    std::string total = "0", sum = "0.0";
    for (std::size_t i = first; i < state_.variables.size(); ++i) {
      const Variable& variable = state_.variables[i];
      if (variable.type == kInt) total = "(" + total + " * 5 + " + variable.name + ")";
      if (variable.type == kFloat) sum += " + " + variable.name;
    }
    if (result == kInt) return total + " + int(" + sum + " > 0.5)";
    if (result == kBool) return "((" + total + " & 1) == 0) != (" + sum + " > 0.5)";
    return state_.types[result].name + "(sin(" + sum + " + float(" + total + " & 15)))";
  }

  std::string function() {
    static const std::vector<int> kResults = {kInt, kInt, kFloat, kFloat, kVec3, kBool, kNothing};
    MadeFunction made{state_.name("f"), random().of(kResults), {}, 0};
    const ScopeOf scope(state_);
    std::string parameters;
    for (int count = random().between(0, 3), i = 0; i < count; ++i) {
      const Parameter one = parameter();
      made.parameters.push_back(one);
      parameters += (i > 0 ? ", " : "") + one.way + " " + state_.types[one.type].name + " " + one.name;
    }
    const std::string result = made.result == kNothing ? "void" : state_.types[made.result].name;
    state_.cost = 0;
    // What is out is not read before it is written.
    for (const Parameter& one : made.parameters) {
      if (one.way == "out") statements_.line(one.name + " = " + statements_.values().literal(one.type) + ";");
      state_.variables.push_back({one.name, one.type, true, kWholeWeight});
    }
    const std::size_t inputs = state_.variables.size();
    statements_.declareCarried({1, 3}, {0, 2});
    declareWholes(random().between(0, 1));
    const Surroundings at{1, false, false, made.result, false};
    statements_.block(random().between(2, state_.options.statements), at);
    if (made.result != kNothing) statements_.line("return " + summary(made.result, inputs) + ";");
    made.cost = state_.cost;
    state_.functions.push_back(made);
    return result + " " + made.name + "(" + parameters + ") {\n" + statements_.takeText() + "}\n";
  }

  std::string mainFunction() {
    const ScopeOf scope(state_);
    state_.cost = 0;
    statements_.line("color = vec4(0.0);");
    if (two_outputs_) statements_.line("ids = ivec2(0);");
    statements_.declareCarried({2, narrow_ ? 3 : 4}, {narrow_ ? 0 : 1, narrow_ ? 1 : 2});
    if (!narrow_) {
      statements_.declare(kBool, "b", 2);
      statements_.declare(kVec3, "v", 2);
      declareWholes(random().between(0, 2));
    }
    // Sampled and derived where all pixels of a quad come by.
    if (random().chance(30)) {
      statements_.line("float quad = texture(image, uv + 0.1 * place.xy).x + dFdx(uv.y);");
      state_.variables.push_back({"quad", kFloat, true, kWholeWeight});
    }
    const Surroundings at{0, false, false, kNothing, true};
    statements_.block(random().between(0, state_.options.statements), at);
    statements_.loop(at);
    statements_.block(random().between(0, state_.options.statements), at);
    fold();
    return "void main() {\n" + statements_.takeText() + "}\n";
  }

  // Of a variable: its scalars and vectors, as many as `leaves` still takes.
  void leavesOf(const std::string& start, int type, std::vector<Field>& leaves) {
    const ShaderType& shape = state_.types[type];
    if (leaves.size() >= kMostLeaves) return;
    for (const Field& field : shape.fields) leavesOf(start + "." + field.name, field.type, leaves);
    if (shape.kind == Kind::kArray || shape.kind == Kind::kMat3)
      for (int i = 0; i < shape.count; ++i) leavesOf(start + "[" + std::to_string(i) + "]", shape.element, leaves);
    else if (shape.kind != Kind::kStruct)
      leaves.push_back({start, type});
  }

  // All that main has kept, in the outputs.
  void fold() {
    statements_.line("int total = 0;");
    statements_.line("float sum = 0.0;");
    for (const Variable& variable : state_.variables) {
      if (!variable.writable) continue;
      std::vector<Field> leaves;
      leavesOf(variable.name, variable.type, leaves);
      for (const Field& leaf : leaves) {
        if (leaf.type == kInt || leaf.type == kBool)
          statements_.line("total = total * 31 + int(" + leaf.name + ");");
        else
          statements_.line("sum += " + (leaf.type == kFloat ? "0.7 * " + leaf.name : "dot(" + leaf.name + ", " + state_.types[leaf.type].name + "(0.4))") + ";");
      }
    }
    statements_.line("color += vec4(float(total & 1023), float(total >> 10 & 1023), sum, 0.5 + 0.01 * sum);");
    if (two_outputs_) statements_.line("ids += ivec2(total, int(4.0 * fract(sum)));");
  }

  ShaderState state_;
  ShaderStatements statements_;
  std::vector<int> structs_, arrays_;
  bool two_outputs_ = false;
  bool narrow_ = false;  // a few scalars and what is done to them, nothing else
};

}  // namespace

std::string randomShader(std::uint64_t seed, const RandomShaderOptions& options) { return ShaderWriter(seed, options).write(); }

}  // namespace reprise
