#include "compiler/analysis/operation_cost.h"

#include <spirv/unified1/GLSL.std.450.h>

namespace reprise {
namespace {

using spv::Op;

double extendedCost(std::uint32_t operation) {
  switch (operation) {
    case GLSLstd450Sin:
    case GLSLstd450Cos:
    case GLSLstd450Exp:
    case GLSLstd450Exp2:
    case GLSLstd450Log:
    case GLSLstd450Log2: return 10;
    case GLSLstd450Tan:
    case GLSLstd450Asin:
    case GLSLstd450Acos:
    case GLSLstd450Atan:
    case GLSLstd450Atan2:
    case GLSLstd450Pow:
    case GLSLstd450Sinh:
    case GLSLstd450Cosh:
    case GLSLstd450Tanh: return 20;
    case GLSLstd450Sqrt:
    case GLSLstd450InverseSqrt: return 4;
    case GLSLstd450Normalize:
    case GLSLstd450Length:
    case GLSLstd450Distance: return 4;
    case GLSLstd450Cross:
    case GLSLstd450Reflect:
    case GLSLstd450Refract:
    case GLSLstd450SmoothStep: return 5;
    case GLSLstd450FMix:
    case GLSLstd450FClamp:
    case GLSLstd450NClamp: return 2;
    case GLSLstd450MatrixInverse: return 40;
    case GLSLstd450Determinant: return 15;
    default: return 1;
  }
}

}  // namespace

double operationCost(const Instruction& instruction, int components) {
  switch (instruction.opcode) {
    case Op::OpExtInst: return extendedCost(instruction.word(1)) * components;
    case Op::OpFDiv:
    case Op::OpFRem:
    case Op::OpFMod:
    case Op::OpSDiv:
    case Op::OpUDiv:
    case Op::OpSMod:
    case Op::OpUMod:
    case Op::OpSRem: return 4.0 * components;
    case Op::OpDot: return 2.0 * components - 1;
    case Op::OpMatrixTimesVector:
    case Op::OpVectorTimesMatrix: return 7.0 * components;
    case Op::OpMatrixTimesMatrix: return 28.0 * components;
    case Op::OpImageSampleImplicitLod:
    case Op::OpImageSampleExplicitLod:
    case Op::OpImageSampleDrefImplicitLod:
    case Op::OpImageSampleDrefExplicitLod:
    case Op::OpImageSampleProjImplicitLod:
    case Op::OpImageSampleProjExplicitLod:
    case Op::OpImageSampleProjDrefImplicitLod:
    case Op::OpImageSampleProjDrefExplicitLod:
    case Op::OpImageGather:
    case Op::OpImageDrefGather: return 60;
    case Op::OpImageFetch:
    case Op::OpImageRead: return 20;
    case Op::OpLoad: return 0.5 * components;
    case Op::OpVariable:
    case Op::OpAccessChain:
    case Op::OpInBoundsAccessChain:
    case Op::OpPhi:
    case Op::OpUndef:
    case Op::OpLoopMerge:
    case Op::OpSelectionMerge:
    case Op::OpBranch:
    case Op::OpReturn:
    case Op::OpLabel:
    case Op::OpSampledImage:
    case Op::OpImage:
    case Op::OpUnreachable:
    case Op::OpBitcast: return 0;
    default: return onlyRearranges(instruction.opcode) ? 0 : components;
  }
}

bool takesImplicitDerivative(Op opcode) {
  switch (opcode) {
    case Op::OpImageSampleImplicitLod:
    case Op::OpImageSampleDrefImplicitLod:
    case Op::OpImageSampleProjImplicitLod:
    case Op::OpImageSampleProjDrefImplicitLod:
    case Op::OpImageSparseSampleImplicitLod:
    case Op::OpImageSparseSampleDrefImplicitLod:
    case Op::OpImageQueryLod:
    case Op::OpDPdx:
    case Op::OpDPdy:
    case Op::OpFwidth:
    case Op::OpDPdxFine:
    case Op::OpDPdyFine:
    case Op::OpFwidthFine:
    case Op::OpDPdxCoarse:
    case Op::OpDPdyCoarse:
    case Op::OpFwidthCoarse: return true;
    default: return false;
  }
}

bool hasSideEffect(Op opcode) {
  switch (opcode) {
    case Op::OpImageWrite:
    case Op::OpCopyMemory:
    case Op::OpCopyMemorySized:
    case Op::OpKill:
    case Op::OpTerminateInvocation:
    case Op::OpDemoteToHelperInvocation:
    case Op::OpControlBarrier:
    case Op::OpMemoryBarrier:
    case Op::OpBeginInvocationInterlockEXT:
    case Op::OpEndInvocationInterlockEXT: return true;
    default: return opcode >= Op::OpAtomicLoad && opcode <= Op::OpAtomicXor;
  }
}

bool onlyRearranges(Op opcode) {
  switch (opcode) {
    case Op::OpCompositeExtract:
    case Op::OpCompositeConstruct:
    case Op::OpCompositeInsert:
    case Op::OpVectorShuffle:
    case Op::OpCopyObject:
    case Op::OpCopyLogical:
    case Op::OpTranspose: return true;
    default: return false;
  }
}

}  // namespace reprise
