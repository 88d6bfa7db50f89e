#include "profiler/harness/made_up_values.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/package/interface_queries.h"

namespace reprise {
namespace {

void put(std::vector<std::byte>& bytes, std::size_t offset, std::uint32_t word) {
  if (offset + 4 <= bytes.size()) std::memcpy(&bytes[offset], &word, 4);
}

void put(std::vector<std::byte>& bytes, std::size_t offset, float value) {
  if (offset + 4 <= bytes.size()) std::memcpy(&bytes[offset], &value, 4);
}

void fillElement(std::vector<std::byte>& bytes, const BlockMember& member, std::size_t offset, MadeUpValues& values) {
  for (int column = 0; column < member.columns; ++column)
    for (int row = 0; row < member.rows; ++row) {
      const int major = member.row_major ? row : column, minor = member.row_major ? column : row;
      const std::size_t at = offset + static_cast<std::size_t>(major) * member.matrix_stride + static_cast<std::size_t>(minor) * 4;
      if (member.scalar != ScalarKind::kFloat) {
        put(bytes, at, values.whole());
      } else if (member.columns > 1) {
        put(bytes, at, (row == column ? 1.0f : 0.0f) + 0.3f * (values.fraction() - 0.5f));
      } else {
        put(bytes, at, values.number());
      }
    }
}

}  // namespace

MadeUpStyle styleOf(std::uint32_t seed) { return static_cast<MadeUpStyle>((seed - 1) % 4); }

std::uint32_t MadeUpValues::bits() {
  state_ = state_ * 1664525u + 1013904223u;
  std::uint32_t bits = state_;
  bits = (bits ^ bits >> 16) * 0x7feb352du;
  bits = (bits ^ bits >> 15) * 0x846ca68bu;
  return bits ^ bits >> 16;
}

float MadeUpValues::fraction() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }

float MadeUpValues::number() {
  constexpr float kLowest[] = {0, -1, 0, 0}, kHighest[] = {1, 1, 8, 2};
  const auto style = static_cast<std::size_t>(style_);
  return kLowest[style] + (kHighest[style] - kLowest[style]) * fraction();
}

std::uint32_t MadeUpValues::whole() {
  constexpr std::uint32_t kCount[] = {4, 2, 8, 16};
  return below(std::min(kCount[static_cast<std::size_t>(style_)], below_));
}

std::uint32_t integerLimit(const ShaderInterface& interface) {
  return shortestDescriptorArray(interface.descriptors).value_or(MadeUpValues::kAnyInteger);
}

std::vector<std::byte> madeUpBlock(const std::vector<BlockMember>& members, std::size_t size_bytes, MadeUpValues& values) {
  std::vector<std::byte> bytes(size_bytes);
  for (std::size_t at = 0; at + 4 <= size_bytes; at += 4) put(bytes, at, values.number());
  for (const BlockMember& member : members)
    for (std::uint32_t element = 0; element < std::max(member.array_length, 1u); ++element)
      fillElement(bytes, member, member.offset + std::size_t{element} * member.array_stride, values);
  return bytes;
}

std::vector<std::byte> blockAtFrame(const std::vector<BlockMember>& members, const std::vector<std::byte>& block, int frame) {
  constexpr float kDrift = 0.02f;
  std::vector<std::byte> moved = block;
  for (const BlockMember& member : members) {
    if (member.scalar != ScalarKind::kFloat || member.columns > 1) continue;
    for (std::uint32_t element = 0; element < std::max(member.array_length, 1u); ++element)
      for (int row = 0; row < member.rows; ++row) {
        const std::size_t at = member.offset + std::size_t{element} * member.array_stride + static_cast<std::size_t>(row) * 4;
        if (at + 4 > block.size()) continue;
        float value = 0;
        std::memcpy(&value, &block[at], 4);
        put(moved, at, value + kDrift * std::sin(static_cast<float>(frame)));
      }
  }
  return moved;
}

}  // namespace reprise
