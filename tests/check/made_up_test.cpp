// Contents that the harness makes up: their ranges, how they are put into texels, and how they drift.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "profiler/harness/made_up_values.h"
#include "profiler/harness/texel_formats.h"

namespace reprise {
namespace {

std::vector<std::byte> encoded(const char* name) {
  const TexelFormat format = texelFormatNamed(name).value();
  std::vector<std::byte> bytes(format.bytes);
  encodeTexel(format, {{1.0f, 0.0f, 0.5f, 1.0f}, {1, 2, 3, 0}}, bytes);
  return bytes;
}

std::vector<std::byte> bytesOf(std::initializer_list<int> values) {
  std::vector<std::byte> bytes;
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

TEST(TexelFormats, PutEveryCodingIntoBytes) {
  EXPECT_EQ(encoded("rgba8"), bytesOf({255, 0, 128, 255}));
  EXPECT_EQ(encoded("rg8_snorm"), bytesOf({127, 0}));
  EXPECT_EQ(encoded("r16"), bytesOf({255, 255}));
  EXPECT_EQ(encoded("rg16f"), bytesOf({0x00, 0x3c, 0, 0}));
  EXPECT_EQ(encoded("r32f"), bytesOf({0, 0, 0x80, 0x3f}));
  EXPECT_EQ(encoded("rgba8ui"), bytesOf({1, 2, 3, 0}));
  EXPECT_EQ(encoded("rg16i"), bytesOf({1, 0, 2, 0}));
  EXPECT_EQ(encoded("rgb10_a2ui"), bytesOf({1, 8, 0x30, 0}));
  EXPECT_FALSE(texelFormatNamed("other"));
}

TEST(MadeUpValues, GoOverTheRangesOfTheirStyles) {
  const std::array<std::pair<float, float>, 4> ranges = {{{0, 1}, {-1, 1}, {0, 8}, {0, 2}}};
  const std::array<std::uint32_t, 4> counts = {4, 2, 8, 16};
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    MadeUpValues values(seed);
    float lowest = 100, highest = -100;
    std::uint32_t most = 0;
    for (int i = 0; i < 1000; ++i) {
      const float number = values.number();
      lowest = std::min(lowest, number), highest = std::max(highest, number);
      most = std::max(most, values.whole());
    }
    const auto [low, high] = ranges[seed - 1];
    EXPECT_GE(lowest, low);
    EXPECT_LT(highest, high);
    EXPECT_GT(highest - lowest, 0.9f * (high - low));
    EXPECT_EQ(most + 1, counts[seed - 1]);
  }
}

TEST(MadeUpValues, IntegersStayWithinArraysOfDescriptors) {
  ShaderInterface interface;
  EXPECT_EQ(integerLimit(interface), MadeUpValues::kAnyInteger);
  interface.descriptors.resize(3);
  interface.descriptors[1].count = 8, interface.descriptors[2].count = 3;
  EXPECT_EQ(integerLimit(interface), 3u);
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    MadeUpValues values(seed, integerLimit(interface));
    for (int i = 0; i < 100; ++i) ASSERT_LT(values.whole(), 3u);
  }
}

TEST(MadeUpValues, OnlyFloatsDriftAndNotInTheFirstFrame) {
  BlockMember tint, count, turn;
  tint.rows = 3;
  count.scalar = ScalarKind::kInt, count.offset = 12;
  turn.rows = turn.columns = 2, turn.offset = 16, turn.matrix_stride = 16;
  const std::vector<BlockMember> members = {tint, count, turn};
  MadeUpValues values(1);
  const std::vector<std::byte> block = madeUpBlock(members, 48, values);
  EXPECT_EQ(blockAtFrame(members, block, 0), block);
  const std::vector<std::byte> moved = blockAtFrame(members, block, 1);
  EXPECT_EQ(moved, blockAtFrame(members, block, 1));
  EXPECT_NE(std::memcmp(moved.data(), block.data(), 12), 0);
  EXPECT_EQ(std::memcmp(&moved[12], &block[12], 36), 0);
}

}  // namespace
}  // namespace reprise
