#include "compiler/source/block_members.h"

#include <optional>
#include <spirv_cross/spirv_cross.hpp>
#include <utility>

namespace reprise {
namespace {

std::optional<ScalarKind> scalarOf(spirv_cross::SPIRType::BaseType type) {
  switch (type) {
    case spirv_cross::SPIRType::Float:
      return ScalarKind::kFloat;
    case spirv_cross::SPIRType::Int:
      return ScalarKind::kInt;
    case spirv_cross::SPIRType::UInt:
      return ScalarKind::kUint;
    default:
      return std::nullopt;
  }
}

constexpr std::uint32_t kUnsizedElements = 16;

class Flattener {
 public:
  Flattener(const spirv_cross::Compiler& compiler, const std::string& block, const ReflectOptions& options)
      : compiler_(compiler), block_(block), options_(options) {}

  Result<void> addStruct(std::uint32_t type_id, const std::string& prefix, std::uint32_t base_offset) {
    const spirv_cross::SPIRType& type = compiler_.get_type(type_id);
    for (std::uint32_t i = 0; i < type.member_types.size(); ++i) {
      std::string name = compiler_.get_member_name(type.self, i);
      if (name.empty()) name = "member" + std::to_string(i);
      BlockMember member;
      member.name = prefix.empty() ? name : prefix + "." + name;
      member.offset = base_offset + compiler_.type_struct_member_offset(type, i);
      member.row_major = compiler_.has_member_decoration(type.self, i, spv::DecorationRowMajor);
      if (compiler_.has_member_decoration(type.self, i, spv::DecorationMatrixStride)) {
        member.matrix_stride = compiler_.type_struct_member_matrix_stride(type, i);
      }
      REPRISE_TRY(addMember(type.member_types[i], member));
    }
    return {};
  }

  std::vector<BlockMember> take() { return std::move(members_); }

 private:
  Result<void> addMember(std::uint32_t type_id, const BlockMember& member) {
    const spirv_cross::SPIRType& type = compiler_.get_type(type_id);
    if (type.pointer) return refuse(member, "is a buffer reference");
    if (!type.array.empty()) return addArray(type_id, member);
    if (type.basetype == spirv_cross::SPIRType::Struct) return addStruct(type_id, member.name, member.offset);
    return addValue(type, member);
  }

  // The outermost dimension of the array is array.back(); its element type is the parent type.
  Result<void> addArray(std::uint32_t type_id, const BlockMember& member) {
    const spirv_cross::SPIRType& type = compiler_.get_type(type_id);
    std::uint32_t length = type.array_size_literal.back() ? type.array.back() : compiler_.get_constant(type.array.back()).scalar();
    if (length == 0 && options_.skip_unknown_members) length = kUnsizedElements;
    if (length == 0) return refuse(member, "is an array without a size");
    const std::uint32_t stride = compiler_.get_decoration(type_id, spv::DecorationArrayStride);
    const spirv_cross::SPIRType& element = compiler_.get_type(type.parent_type);
    BlockMember entry = member;
    if (element.array.empty() && element.basetype != spirv_cross::SPIRType::Struct) {
      entry.array_length = length;
      entry.array_stride = stride;
      return addMember(type.parent_type, entry);
    }
    for (std::uint32_t i = 0; i < length; ++i) {
      entry.name = member.name + "[" + std::to_string(i) + "]";
      entry.offset = member.offset + i * stride;
      REPRISE_TRY(addMember(type.parent_type, entry));
    }
    return {};
  }

  Result<void> addValue(const spirv_cross::SPIRType& type, BlockMember member) {
    const std::optional<ScalarKind> scalar = scalarOf(type.basetype);
    if (!scalar || type.width != 32) return refuse(member, "is not made of 32-bit floats or integers");
    if (members_.size() >= kMaxBlockMembers) {
      return refuse(member, "is one of more than " + std::to_string(kMaxBlockMembers) + " members");
    }
    member.scalar = *scalar;
    member.rows = static_cast<int>(type.vecsize);
    member.columns = static_cast<int>(type.columns);
    if (type.columns == 1) {
      member.matrix_stride = 0;
      member.row_major = false;
    }
    members_.push_back(std::move(member));
    return {};
  }

  Result<void> refuse(const BlockMember& member, const std::string& what) const {
    if (options_.skip_unknown_members) return {};
    return Error{ErrorKind::kInput,
            "source.unsupported",
            "the member \"" + block_ + "." + member.name + "\" " + what + ", which blocks may not hold here",
            {}};
  }

  const spirv_cross::Compiler& compiler_;
  const std::string& block_;
  ReflectOptions options_;
  std::vector<BlockMember> members_;
};

}  // namespace

Result<std::vector<BlockMember>> flattenBlock(const spirv_cross::Compiler& compiler, std::uint32_t type_id,
                                              const std::string& block, const ReflectOptions& options) {
  Flattener flattener(compiler, block, options);
  REPRISE_TRY(flattener.addStruct(type_id, "", 0));
  return flattener.take();
}

}  // namespace reprise
