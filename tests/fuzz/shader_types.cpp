#include "tests/fuzz/shader_types.h"

#include <algorithm>

namespace reprise {

TypeTable::TypeTable() {
  types_ = {{Kind::kBool, "bool"},
            {Kind::kInt, "int"},
            {Kind::kFloat, "float"},
            {Kind::kVec2, "vec2", kFloat, 2},
            {Kind::kVec3, "vec3", kFloat, 3},
            {Kind::kVec4, "vec4", kFloat, 4},
            {Kind::kMat3, "mat3", kVec3, 3}};
}

int TypeTable::arrayOf(int element, int count) {
  std::string name = types_[static_cast<std::size_t>(element)].name;
  name.insert(std::min(name.find('['), name.size()), "[" + std::to_string(count) + "]");  // the outermost comes first
  const auto same = std::find_if(types_.begin(), types_.end(), [&](const ShaderType& type) { return type.name == name; });
  if (same != types_.end()) return static_cast<int>(same - types_.begin());
  types_.push_back({Kind::kArray, name, element, count});
  return size() - 1;
}

int TypeTable::structOf(const std::string& name, std::vector<Field> fields) {
  types_.push_back({Kind::kStruct, name, 0, 0, std::move(fields)});
  return size() - 1;
}

bool TypeTable::reaches(int type, int wanted) const {
  if (type == wanted) return true;
  const ShaderType& shape = (*this)[type];
  if (wanted == kVec2 && (shape.kind == Kind::kVec3 || shape.kind == Kind::kVec4)) return true;  // .xy and the like
  if (wanted == kVec3 && shape.kind == Kind::kVec4) return true;
  if (shape.count > 0) return reaches(shape.element, wanted);
  return std::any_of(shape.fields.begin(), shape.fields.end(), [&](const Field& field) { return reaches(field.type, wanted); });
}

std::string TypeTable::body(int type) const {
  std::string text = "{";
  for (const Field& field : (*this)[type].fields) text += " " + (*this)[field.type].name + " " + field.name + ";";
  return text + " }";
}

std::string TypeTable::declare(const std::vector<int>& structs) const {
  std::string text;
  for (const int type : structs) text += "struct " + (*this)[type].name + " " + body(type) + ";\n";
  return text;
}

}  // namespace reprise
