// The types of a random shader: scalars, vectors, a matrix, arrays and structures, and how one gets from a value to its parts.
#pragma once

#include <string>
#include <vector>

namespace reprise {

// The first of a table's types are these, in this order.
enum class Kind { kBool, kInt, kFloat, kVec2, kVec3, kVec4, kMat3, kArray, kStruct };

constexpr int typeOf(Kind kind) { return static_cast<int>(kind); }
constexpr int kBool = typeOf(Kind::kBool), kInt = typeOf(Kind::kInt), kFloat = typeOf(Kind::kFloat), kVec2 = typeOf(Kind::kVec2),
              kVec3 = typeOf(Kind::kVec3), kVec4 = typeOf(Kind::kVec4), kMat3 = typeOf(Kind::kMat3);

struct Field {
  std::string name;
  int type = 0;
};

struct ShaderType {
  Kind kind = Kind::kBool;
  std::string name;           // as declarations and constructors write it
  int element = 0, count = 0;  // of arrays, vectors and the matrix (its columns); count is 0 for the others
  std::vector<Field> fields;  // of structures
};

class TypeTable {
 public:
  TypeTable();

  const ShaderType& operator[](int type) const { return types_[static_cast<std::size_t>(type)]; }
  int size() const { return static_cast<int>(types_.size()); }

  int arrayOf(int element, int count);
  int structOf(const std::string& name, std::vector<Field> fields);

  // Whether a value of `type` is or contains one of type `wanted`.
  bool reaches(int type, int wanted) const;
  // The declarations "struct Name { ... };" of these types, a line each.
  std::string declare(const std::vector<int>& structs) const;
  // "{ int a; float b; }": the body of a structure or of a block.
  std::string body(int type) const;

 private:
  std::vector<ShaderType> types_;
};

}  // namespace reprise
