#include "profiler/harness/integer_inputs.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "profiler/harness/covering_array.h"

namespace reprise {
namespace {

// "lamps[2].kind" and "lamps[0].kind" are elements of "lamps[].kind".
std::string withoutIndices(const std::string& name) {
  std::string text;
  bool inside = false;
  for (const char letter : name) {
    if (letter == ']') inside = false;
    if (!inside) text += letter;
    if (letter == '[') inside = true;
  }
  return text;
}

void put(const IntegerValue& one, std::uint32_t below, std::span<std::byte> bytes) {
  for (std::size_t i = 0; i < one.input.offsets.size(); ++i) {
    const std::uint32_t value = (one.value + static_cast<std::uint32_t>(i)) % kIntegerValues % below;
    if (one.input.offsets[i] + 4 <= bytes.size()) std::memcpy(&bytes[one.input.offsets[i]], &value, 4);
  }
}

}  // namespace

std::vector<IntegerInput> integersIn(const std::vector<BlockMember>& members, std::uint32_t first_byte, std::uint32_t end_byte) {
  std::vector<IntegerInput> inputs;
  std::vector<std::string> names;
  for (const BlockMember& member : members) {
    if (member.scalar == ScalarKind::kFloat || member.columns > 1 || member.offset < first_byte || member.offset >= end_byte) continue;
    for (int row = 0; row < member.rows; ++row) {
      const std::string name = withoutIndices(member.name) + "." + std::to_string(row);
      const auto known = std::find(names.begin(), names.end(), name);
      const auto column = static_cast<std::size_t>(known - names.begin());
      if (known == names.end()) {
        names.push_back(name);
        inputs.emplace_back();
        inputs.back().kind = IntegerInput::Kind::kBlock;
      }
      for (std::uint32_t element = 0; element < std::max(member.array_length, 1u); ++element)
        inputs[column].offsets.push_back(member.offset + element * member.array_stride + static_cast<std::uint32_t>(row) * 4);
    }
  }
  return inputs;
}

std::vector<IntegerAssignment> coveringAssignments(std::span<const IntegerInput> inputs, std::size_t most_rows) {
  std::vector<IntegerAssignment> assignments;
  for (const std::vector<std::uint32_t>& row : coveringArray(inputs.size(), kIntegerValues, most_rows)) {
    IntegerAssignment assignment;
    for (std::size_t column = 0; column < row.size(); ++column) assignment.push_back({inputs[column], row[column]});
    assignments.push_back(std::move(assignment));
  }
  return assignments;
}

void putIntegers(const IntegerAssignment& assignment, const Descriptor& block, std::uint32_t below, std::span<std::byte> bytes) {
  for (const IntegerValue& one : assignment)
    if (one.input.kind == IntegerInput::Kind::kBlock && one.input.set == block.set && one.input.binding == block.binding) put(one, below, bytes);
}

void putPushedIntegers(const IntegerAssignment& assignment, std::uint32_t below, std::span<std::byte> bytes) {
  for (const IntegerValue& one : assignment)
    if (one.input.kind == IntegerInput::Kind::kPushConstants) put(one, below, bytes);
}

}  // namespace reprise
