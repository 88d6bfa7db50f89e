#include "cli/check/covering_integers.h"

#include <algorithm>

#include "compiler/analysis/deciding_inputs.h"

namespace reprise {
namespace {

std::vector<IntegerInput> varyingIntegers(const DecidingInput& input) {
  std::vector<IntegerInput> found;
  for (std::uint32_t i = 0; input.is_integer && i < input.components; ++i) {
    found.emplace_back();
    found.back().location = input.location;
    found.back().component = input.component + i;
  }
  return found;
}

std::vector<IntegerInput> blockIntegers(const ShaderInterface& interface, const DecidingInput& input) {
  if (input.kind == DecidingInput::Kind::kPushConstants) {
    std::vector<IntegerInput> found = integersIn(interface.push_constant_members, input.first_byte, input.end_byte);
    for (IntegerInput& one : found) one.kind = IntegerInput::Kind::kPushConstants;
    return found;
  }
  for (const Descriptor& descriptor : interface.descriptors) {
    if (descriptor.set != input.set || descriptor.binding != input.binding) continue;
    std::vector<IntegerInput> found = integersIn(descriptor.members, input.first_byte, input.end_byte);
    for (IntegerInput& one : found) one.set = input.set, one.binding = input.binding;
    return found;
  }
  return {};
}

}  // namespace

std::vector<IntegerInput> decidingIntegers(const ShaderProgram& program) {
  std::vector<IntegerInput> integers;
  for (const DecidingInput& input : decidingInputs(*program.fragment, program.analysis)) {
    const bool varies = input.kind == DecidingInput::Kind::kVarying;
    for (IntegerInput& one : varies ? varyingIntegers(input) : blockIntegers(program.interface, input))
      if (integers.size() < kMostCoveredIntegers && std::find(integers.begin(), integers.end(), one) == integers.end())
        integers.push_back(std::move(one));
  }
  return integers;
}

std::vector<IntegerAssignment> coveringAssignments(const ShaderProgram& program, std::size_t most_rows) {
  return coveringAssignments(decidingIntegers(program), most_rows);
}

}  // namespace reprise
