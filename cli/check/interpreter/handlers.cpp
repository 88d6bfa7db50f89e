#include <array>

#include "cli/check/interpreter/machine.h"

namespace reprise::interpreter {

using spv::Op;

Handler handlerOf(Op op) {
  for (const auto find : {flowHandler, memoryHandler, compositeHandler, floatHandler, integerHandler, imageHandler, atomicHandler})
    if (const Handler handler = find(op)) return handler;
  return nullptr;
}

std::string nameOfInstruction(Op op) {
  struct Range {
    Op first, last;
    const char* name;
  };
  static constexpr std::array<Range, 9> kRanges = {{
      {Op::OpGroupNonUniformElect, Op::OpGroupNonUniformQuadSwap, "subgroup operations (OpGroupNonUniform...)"},
      {Op::OpSubgroupBallotKHR, Op::OpSubgroupReadInvocationKHR, "subgroup operations (OpSubgroup...KHR)"},
      {Op::OpRayQueryInitializeKHR, Op::OpRayQueryGetIntersectionTypeKHR, "ray queries (OpRayQuery...)"},
      {Op::OpRayQueryGetRayTMinKHR, Op::OpRayQueryGetIntersectionWorldToObjectKHR, "ray queries (OpRayQueryGet...)"},
      {Op::OpImageSparseSampleImplicitLod, Op::OpImageSparseTexelsResident, "sparse images (OpImageSparse...)"},
      {Op::OpPtrAccessChain, Op::OpPtrAccessChain, "OpPtrAccessChain"},
      {Op::OpConvertUToPtr, Op::OpConvertUToPtr, "OpConvertUToPtr"},
      {Op::OpControlBarrier, Op::OpControlBarrier, "OpControlBarrier"},
      {Op::OpExtInst, Op::OpExtInst, "OpExtInst"},
  }};
  for (const Range& range : kRanges)
    if (op >= range.first && op <= range.last) return range.name;
  return "the instruction with the opcode " + std::to_string(static_cast<std::uint32_t>(op));
}

}  // namespace reprise::interpreter
