#include "compiler/transforms/type_size.h"

#include <algorithm>

namespace reprise {

using spv::Op;

std::uint32_t memberSize(const Module& module, std::uint32_t struct_id, std::uint32_t member) {
  const std::uint32_t type_id = findGlobal(module, struct_id)->word(member);
  const Instruction* type = findGlobal(module, type_id);
  if (type->opcode != Op::OpTypeMatrix) return sizeOf(module, type_id);
  const std::uint32_t columns = type->word(1), rows = findGlobal(module, type->word(0))->word(1);
  return (memberDecorationOf(module, struct_id, member, spv::Decoration::RowMajor) ? rows : columns) *
         memberDecorationOf(module, struct_id, member, spv::Decoration::MatrixStride).value_or(16);
}

std::uint32_t sizeOf(const Module& module, std::uint32_t type_id) {
  const Instruction* type = findGlobal(module, type_id);
  switch (type->opcode) {
    case Op::OpTypeInt:
    case Op::OpTypeFloat: return type->word(0) / 8;
    case Op::OpTypeVector: return type->word(1) * sizeOf(module, type->word(0));
    case Op::OpTypeMatrix: return type->word(1) * 16;
    case Op::OpTypeArray: {
      const Instruction* length = findGlobal(module, type->word(1));
      return length->word(0) * decorationOf(module, type_id, spv::Decoration::ArrayStride).value_or(16);
    }
    case Op::OpTypeStruct: {
      std::uint32_t end = 0;
      for (std::uint32_t member = 0; member < type->operands.size(); ++member)
        end = std::max(end, memberDecorationOf(module, type_id, member, spv::Decoration::Offset).value_or(0) + memberSize(module, type_id, member));
      return (end + 15) / 16 * 16;
    }
    default: return 0;
  }
}

}  // namespace reprise
