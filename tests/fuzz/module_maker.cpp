#include "tests/fuzz/module_maker.h"

namespace reprise {

using spv::Op;
using spv::StorageClass;

namespace {

template <typename Enum>
Operand literal(Enum value) {
  return literalOperand(static_cast<std::uint32_t>(value));
}

}  // namespace

ModuleMaker::ModuleMaker() {
  module_.capabilities = {makeInstruction(Op::OpCapability, 0, 0, {literal(spv::Capability::Shader)})};
  module_.memory_model = {makeInstruction(Op::OpMemoryModel, 0, 0,
                                          {literal(spv::AddressingModel::Logical), literal(spv::MemoryModel::GLSL450)})};
  void_ = global(Op::OpTypeVoid, 0, {});
  real_ = floatType(module_);
  boolean_ = global(Op::OpTypeBool, 0, {});
  const std::uint32_t main_type = global(Op::OpTypeFunction, 0, {idOperand(void_)});
  function_type_ = global(Op::OpTypeFunction, 0, {idOperand(real_), idOperand(real_)});
  input_pointer_ = pointerType(module_, StorageClass::Input, real_);
  color_ = addVariable(module_, StorageClass::Output, real_, "color");
  addDecoration(module_, color_, spv::Decoration::Location, {0});
  const std::uint32_t main = id();
  module_.entry_points = {makeInstruction(Op::OpEntryPoint, 0, 0, {literal(spv::ExecutionModel::Fragment), idOperand(main),
                                                                   stringOperand("main"), idOperand(color_)})};
  module_.execution_modes = {
      makeInstruction(Op::OpExecutionMode, 0, 0, {idOperand(main), literal(spv::ExecutionMode::OriginUpperLeft)})};
  module_.functions.push_back({makeInstruction(Op::OpFunction, void_, main, {literalOperand(0), idOperand(main_type)}), {}, {}});
  begin(id());
  x_ = add(Op::OpLoad, real_, {idOperand(varying(0))});
  condition_ = add(Op::OpFOrdLessThan, boolean_, {idOperand(x_), idOperand(constant(0.5f))});
}

std::uint32_t ModuleMaker::global(Op opcode, std::uint32_t type, std::vector<Operand> operands) {
  module_.globals.push_back(makeInstruction(opcode, type, id(), std::move(operands)));
  return module_.globals.back().result_id;
}

std::uint32_t ModuleMaker::varying(std::uint32_t location) {
  const std::uint32_t variable = global(Op::OpVariable, input_pointer_, {literal(StorageClass::Input)});
  addDecoration(module_, variable, spv::Decoration::Location, {location});
  module_.entry_points.front().operands.push_back(idOperand(variable));
  return variable;
}

std::uint32_t ModuleMaker::localVariable(std::uint32_t type) {
  const std::uint32_t pointer = pointerType(module_, StorageClass::Function, type);
  std::vector<Instruction>& first = module_.functions[current_].blocks.front().instructions;
  first.insert(first.begin(), makeInstruction(Op::OpVariable, pointer, id(), {literal(StorageClass::Function)}));
  return first.front().result_id;
}

std::uint32_t ModuleMaker::add(Op opcode, std::uint32_t type, std::vector<Operand> operands) {
  const std::uint32_t result = type == 0 ? 0 : id();
  module_.functions[current_].blocks.back().instructions.push_back(makeInstruction(opcode, type, result, std::move(operands)));
  return result;
}

void ModuleMaker::begin(std::uint32_t label) { module_.functions[current_].blocks.push_back({label, {}}); }

std::uint32_t ModuleMaker::beginFunction(std::uint32_t* parameter) {
  const std::uint32_t function = id();
  *parameter = id();
  module_.functions.push_back({makeInstruction(Op::OpFunction, real_, function, {literalOperand(0), idOperand(function_type_)}),
                               {makeInstruction(Op::OpFunctionParameter, real_, *parameter, {})},
                               {}});
  current_ = module_.functions.size() - 1;
  begin(id());
  return function;
}

std::vector<std::uint32_t> ModuleMaker::finish(std::uint32_t value) {
  resumeMain();
  end(Op::OpStore, {idOperand(color_), idOperand(value)});
  end(Op::OpReturn);
  return writeModule(module_);
}

}  // namespace reprise
