#include "compiler/source/interface_names.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "compiler/source/named_words.h"

namespace reprise {
namespace {

using spv::Decoration;
using spv::Op;
using spv::StorageClass;
using Variable = NamedWords::Variable;

constexpr const char* kPushConstants = "push_constants";
const std::string kKinds[] = {"block_", "texture_", "sampler_", "image_", "member", "input_", "varying_", "output_"};

bool isBlock(const NamedWords& module, const Variable& variable) {
  const bool holds_blocks = variable.storage == StorageClass::Uniform || variable.storage == StorageClass::StorageBuffer ||
                            variable.storage == StorageClass::PushConstant;
  const NamedWords::Type* type = module.type(variable.type);
  return holds_blocks && type != nullptr && type->opcode == Op::OpTypeStruct;
}

// Names that compilers of HLSL and Slang make from a declaration's.
bool isCompilersOwn(const std::string& type_name) {
  constexpr const char* kEndings[] = {"_std140", "_std430", "_natural", "_scalar"};
  if (type_name.starts_with("type.") || type_name.starts_with("SLANG_ParameterGroup_")) return true;
  return std::any_of(std::begin(kEndings), std::end(kEndings), [&](const char* ending) { return type_name.ends_with(ending); });
}

std::string placed(const std::string& kind, const NamedWords& module, std::uint32_t id) {
  return kind + "_" + std::to_string(module.decoration(id, Decoration::DescriptorSet).value_or(0)) + "_" +
         std::to_string(module.decoration(id, Decoration::Binding).value_or(0));
}

void nameMembers(NamedWords& module, std::uint32_t type_id, std::set<std::uint32_t>& done) {
  type_id = module.withoutArrays(type_id);
  const NamedWords::Type* type = module.type(type_id);
  if (type == nullptr || type->opcode != Op::OpTypeStruct || !done.insert(type_id).second) return;
  for (std::uint32_t member = 0; member < type->operands.size(); ++member) {
    if (module.memberDecoration(type_id, member, Decoration::BuiltIn)) return;
    if (module.memberName(type_id, member).empty()) module.setMemberName(type_id, member, "member" + std::to_string(member));
    nameMembers(module, type->operands[member], done);
  }
}

void nameBlocks(NamedWords& module) {
  std::map<std::uint32_t, int> blocks_of_type;
  for (const Variable& variable : module.variables()) blocks_of_type[variable.type] += isBlock(module, variable) ? 1 : 0;
  std::set<std::uint32_t> done;
  for (const Variable& variable : module.variables()) {
    if (!isBlock(module, variable)) continue;
    nameMembers(module, variable.type, done);
    const bool shared = blocks_of_type[variable.type] > 1;
    const std::string type_name = module.name(variable.type), own = module.name(variable.id);
    const std::string by_place = variable.storage == StorageClass::PushConstant ? kPushConstants : placed("block", module, variable.id);
    const bool keeps_type = !shared && !type_name.empty() && !(isCompilersOwn(type_name) && !own.empty());
    if (!keeps_type && own.empty()) module.setName(variable.id, by_place);
    if (!keeps_type && !shared) module.setName(variable.type, own.empty() ? by_place : own);
  }
  for (const auto& [type, blocks] : blocks_of_type)
    if (blocks > 1) module.setName(type, "");
}

void nameImages(NamedWords& module) {
  for (const Variable& variable : module.variables()) {
    const NamedWords::Type* type = module.type(variable.type);
    if (variable.storage != StorageClass::UniformConstant || type == nullptr || !module.name(variable.id).empty()) continue;
    const bool stores = type->opcode == Op::OpTypeImage && type->operands.size() > 5 && type->operands[5] == 2;
    module.setName(variable.id, placed(type->opcode == Op::OpTypeSampler ? "sampler" : stores ? "image" : "texture", module, variable.id));
  }
}

// "position" of "input.position"; what a mesh calls it where that is a semantic of HLSL.
std::string attributeName(const std::string& name) {
  static const std::map<std::string, std::string> kSemantics = {
      {"position", "position"}, {"position0", "position"}, {"normal", "normal"}, {"normal0", "normal"}, {"tangent", "tangent"},
      {"tangent0", "tangent"},  {"texcoord", "uv"},        {"texcoord0", "uv"},  {"color", "color"},    {"color0", "color"}};
  std::string last = name.substr(name.rfind('.') == std::string::npos ? 0 : name.rfind('.') + 1);
  std::string small = last;
  std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto semantic = kSemantics.find(small);
  return semantic == kSemantics.end() ? last : semantic->second;
}

std::string locationName(const char* kind, const NamedWords& module, std::uint32_t id) {
  std::string name = kind + std::string("_") + std::to_string(*module.decoration(id, Decoration::Location));
  if (const std::uint32_t component = module.decoration(id, Decoration::Component).value_or(0); component != 0) name += "_" + std::to_string(component);
  return name;
}

void nameLocations(NamedWords& module) {
  const bool vertex = module.stage() == spv::ExecutionModel::Vertex;
  std::set<std::string> given;
  for (const Variable& variable : module.variables()) given.insert(module.name(variable.id));
  for (const Variable& variable : module.variables()) {
    const bool reads = variable.storage == StorageClass::Input;
    if ((!reads && variable.storage != StorageClass::Output) || !module.decoration(variable.id, Decoration::Location)) continue;
    const std::string name = module.name(variable.id);
    if (name.empty()) {
      module.setName(variable.id, locationName(vertex && reads ? "input" : vertex == reads ? "output" : "varying", module, variable.id));
    } else if (vertex && reads && name.find('.') != std::string::npos && given.insert(attributeName(name)).second) {
      module.setName(variable.id, attributeName(name));
    }
  }
}

// Of two modules: whether a type is the same in layout and kind.
class Shapes {
 public:
  Shapes(const NamedWords& a, const NamedWords& b) : a_(a), b_(b) {}

  bool same(std::uint32_t a, std::uint32_t b) const {
    const NamedWords::Type *one = a_.type(a), *other = b_.type(b);
    if (one == nullptr || other == nullptr || one->opcode != other->opcode) return false;
    switch (one->opcode) {
      case Op::OpTypeStruct:
        return one->operands.size() == other->operands.size() && common(a, b) == one->operands.size();
      case Op::OpTypeArray:
        return a_.constant(one->operands[1]) == b_.constant(other->operands[1]) && sameElements(a, b);
      case Op::OpTypeRuntimeArray: return sameElements(a, b);
      case Op::OpTypeVector:
      case Op::OpTypeMatrix: return one->operands[1] == other->operands[1] && same(one->operands[0], other->operands[0]);
      default: return one->operands == other->operands;
    }
  }

  // How many members two structs have in common at their beginning, by types and offsets.
  std::size_t common(std::uint32_t a, std::uint32_t b) const {
    const NamedWords::Type *one = a_.type(a), *other = b_.type(b);
    std::uint32_t member = 0;
    while (member < std::min(one->operands.size(), other->operands.size()) && sameMember(a, b, member)) ++member;
    return member;
  }

 private:
  bool sameElements(std::uint32_t a, std::uint32_t b) const {
    return a_.decoration(a, Decoration::ArrayStride) == b_.decoration(b, Decoration::ArrayStride) &&
           same(a_.type(a)->operands[0], b_.type(b)->operands[0]);
  }

  bool sameMember(std::uint32_t a, std::uint32_t b, std::uint32_t member) const {
    for (const Decoration decoration : {Decoration::Offset, Decoration::MatrixStride, Decoration::RowMajor})
      if (a_.memberDecoration(a, member, decoration) != b_.memberDecoration(b, member, decoration)) return false;
    return same(a_.type(a)->operands[member], b_.type(b)->operands[member]);
  }

  const NamedWords& a_;
  const NamedWords& b_;
};

// Stands for a missing name.
bool isPlaceName(const std::string& name) {
  const auto numbered = [&](const std::string& kind) {
    return name.size() > kind.size() && name.starts_with(kind) && std::all_of(name.begin() + static_cast<std::ptrdiff_t>(kind.size()), name.end(), [](char c) {
      return (c >= '0' && c <= '9') || c == '_';
    });
  };
  return name == kPushConstants || std::any_of(std::begin(kKinds), std::end(kKinds), numbered);
}

// Copies names from one module to the other: all, or those that the other lacks.
class NameCopy {
 public:
  NameCopy(const NamedWords& from, NamedWords& to, bool only_missing) : from_(from), to_(to), only_missing_(only_missing) {}

  void copy(std::uint32_t from, std::uint32_t to) {
    if (takes(from_.name(from), to_.name(to))) to_.setName(to, from_.name(from));
  }

  void copyMembers(std::uint32_t from, std::uint32_t to, std::size_t members) {
    for (std::uint32_t member = 0; member < members; ++member) {
      const std::string name = from_.memberName(from, member);
      if (takes(name, to_.memberName(to, member))) to_.setMemberName(to, member, name);
      const std::uint32_t inner_from = from_.withoutArrays(from_.type(from)->operands[member]);
      const std::uint32_t inner_to = to_.withoutArrays(to_.type(to)->operands[member]);
      if (from_.type(inner_from)->opcode == Op::OpTypeStruct) copyMembers(inner_from, inner_to, from_.type(inner_from)->operands.size());
    }
  }

 private:
  bool takes(const std::string& name, const std::string& instead_of) const {
    return !name.empty() && (!only_missing_ || (isPlaceName(instead_of) && !isPlaceName(name)));
  }

  const NamedWords& from_;
  NamedWords& to_;
  bool only_missing_;
};

// Where the name of a block stands: at its type, or at the variable.
std::uint32_t bearerOf(const NamedWords& module, const Variable& block) {
  return module.name(block.type).empty() ? block.id : block.type;
}

bool atOnePlace(const NamedWords& a, const Variable& one, const NamedWords& b, const Variable& other) {
  if (one.storage == StorageClass::PushConstant) return true;
  if (one.storage == StorageClass::Input || one.storage == StorageClass::Output) return false;
  const auto same = [&](Decoration decoration) { return a.decoration(one.id, decoration) == b.decoration(other.id, decoration); };
  return same(Decoration::DescriptorSet) && same(Decoration::Binding);
}

std::vector<std::uint32_t> withNamesOf(std::span<const std::uint32_t> other, std::span<const std::uint32_t> words, bool only_missing) {
  const NamedWords from(other);
  NamedWords to(words);
  const Shapes shapes(from, to);
  NameCopy names(from, to, only_missing);
  for (const Variable& named : from.variables())
    for (const Variable& same : to.variables()) {
      if (named.storage != same.storage || !atOnePlace(from, named, to, same)) continue;
      if (named.storage == StorageClass::UniformConstant) names.copy(named.id, same.id);
      if (!isBlock(from, named) || !isBlock(to, same)) continue;
      const std::size_t members = shapes.common(named.type, same.type);
      if (members < std::min(from.type(named.type)->operands.size(), to.type(same.type)->operands.size())) continue;
      names.copy(bearerOf(from, named), bearerOf(to, same));
      names.copyMembers(named.type, same.type, members);
    }
  return to.take();
}

}  // namespace

std::vector<std::uint32_t> withInterfaceNames(std::span<const std::uint32_t> words) {
  NamedWords module(words);
  nameBlocks(module);
  nameImages(module);
  nameLocations(module);
  return module.take();
}

void shareInterfaceNames(std::vector<std::uint32_t>& vertex, std::vector<std::uint32_t>& fragment) {
  vertex = withNamesOf(fragment, vertex, true);
  fragment = withNamesOf(vertex, fragment, false);
}

}  // namespace reprise
