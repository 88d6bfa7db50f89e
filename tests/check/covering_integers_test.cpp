// All pairs of small integers: the rows cover them, and the harness gives what they say.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <set>

#include "cli/check/covering_integers.h"
#include "cli/check/harness_program.h"
#include "compiler/source/compile.h"
#include "compiler/strategies/build_package.h"
#include "profiler/harness/covering_array.h"
#include "profiler/harness/harness.h"
#include "runtime/vulkan/context.h"

namespace reprise {
namespace {

using Rows = std::vector<std::vector<std::uint32_t>>;

// Pairs of columns and of their values that some row shows.
std::size_t pairsShown(const Rows& rows) {
  std::set<std::array<std::size_t, 4>> pairs;
  for (const auto& row : rows)
    for (std::size_t a = 0; a < row.size(); ++a)
      for (std::size_t b = a + 1; b < row.size(); ++b) pairs.insert({a, b, row[a], row[b]});
  return pairs.size();
}

TEST(CoveringArray, ShowsEveryPairOfValuesInEveryTwoColumns) {
  for (const std::size_t columns : {2u, 3u, 5u, 8u, 12u}) {
    const Rows rows = coveringArray(columns, 4, 1000);
    EXPECT_EQ(pairsShown(rows), columns * (columns - 1) / 2 * 16) << columns;
    EXPECT_GE(rows.size(), 16u);
    EXPECT_LE(rows.size(), 40u) << "a few rows are the point of it";
    for (const auto& row : rows) ASSERT_EQ(row.size(), columns);
    EXPECT_EQ(rows, coveringArray(columns, 4, 1000));
  }
}

TEST(CoveringArray, OfFewRowsShowsEachValueOfEachColumnFirst) {
  const Rows rows = coveringArray(6, 4, 4);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(pairsShown(rows), 4u * 15) << "no pair twice";
  for (std::size_t column = 0; column < 6; ++column) {
    std::set<std::uint32_t> values;
    for (const auto& row : rows) values.insert(row[column]);
    EXPECT_EQ(values.size(), 4u);
  }
}

TEST(CoveringArray, OfOneColumnOrNoneIsPlain) {
  EXPECT_EQ(coveringArray(1, 4, 10), (Rows{{0}, {1}, {2}, {3}}));
  EXPECT_EQ(coveringArray(1, 4, 2).size(), 2u);
  EXPECT_TRUE(coveringArray(0, 4, 10).empty());
  EXPECT_TRUE(coveringArray(3, 4, 0).empty());
}

TEST(IntegerInputs, ElementsOfAnArrayAreOneInput) {
  BlockMember first, second, plain, number;
  first.name = "lamps[0].kind", first.scalar = ScalarKind::kInt, first.offset = 16;
  second = first;
  second.name = "lamps[1].kind", second.offset = 48;
  plain.name = "sides", plain.scalar = ScalarKind::kUint, plain.rows = 2, plain.offset = 64;
  number.name = "gain", number.offset = 72;
  const std::vector<IntegerInput> inputs = integersIn({first, second, plain, number}, 0, 100);
  ASSERT_EQ(inputs.size(), 3u);
  EXPECT_EQ(inputs[0].offsets, (std::vector<std::uint32_t>{16, 48}));
  EXPECT_EQ(inputs[1].offsets, (std::vector<std::uint32_t>{64}));
  EXPECT_EQ(inputs[2].offsets, (std::vector<std::uint32_t>{68}));
  EXPECT_EQ(integersIn({first, second, plain, number}, 64, 68).size(), 2u);

  Descriptor block;
  std::vector<std::byte> bytes(80);
  putIntegers({{inputs[0], 3}}, block, 100, bytes);
  EXPECT_EQ(static_cast<int>(bytes[16]), 3);
  EXPECT_EQ(static_cast<int>(bytes[48]), 0) << "the next value for the next element";
  putIntegers({{inputs[0], 3}}, block, 2, bytes);
  EXPECT_EQ(static_cast<int>(bytes[16]), 1) << "below the limit";
  block.binding = 1;
  putIntegers({{inputs[1], 2}}, block, 100, bytes);
  EXPECT_EQ(static_cast<int>(bytes[64]), 0) << "another block";
}

constexpr const char* kDecided = R"(#version 450
layout(location = 0) in vec3 place;
layout(location = 3) flat in uint way;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Scene { vec4 tint; int count; int unread; } scene;
struct Item { vec4 tint; int kind; };
layout(set = 0, binding = 1) readonly buffer List { Item items[]; } list;
layout(push_constant) uniform Draw { int item; } draw;
void main() {
  float sum = 0.0;
  for (int i = 0; i < scene.count; ++i) sum += sin(place.x + float(i));
  switch (way) { case 0u: sum += 1.0; break; case 1u: sum = cos(sum); break; default: break; }
  if (list.items[draw.item].kind == 2) sum *= 2.0;
  color = vec4(float(scene.count), float(way), float(draw.item), float(list.items[draw.item].kind)) + 0.0001 * sum;
}
)";

TEST(CoveringIntegers, AreThoseThatDecide) {
  const ShaderProgram program = harnessProgram(compileText(kDecided, "test.frag", {}).value()).value();
  const std::vector<IntegerInput> integers = decidingIntegers(program);
  ASSERT_EQ(integers.size(), 4u);
  EXPECT_EQ(coveringAssignments(program, 5).size(), 5u);
  EXPECT_TRUE(coveringAssignments(harnessProgram(compileText("#version 450\nlayout(location = 0) out vec4 color;\nlayout(location = 0) flat in int a;\n"
                                                             "void main() { color = vec4(a); }\n", "test.frag", {}).value()).value(), 5).empty());
}

TEST(CoveringIntegers, AreGivenByTheHarness) {
  const ShaderProgram program = harnessProgram(compileText(kDecided, "test.frag", {}).value()).value();
  const Context context = Context::create({}).value();
  Commands commands = Commands::create(context).value();
  VariantOptions original;
  original.strategy = "original";
  const Package package = buildPackage(program, {}, original, {}).value();
  for (const IntegerAssignment& assignment : coveringAssignments(program, 3)) {
    HarnessOptions options;
    options.integers = assignment;
    Harness harness = Harness::create(context, commands, program.interface, options).value();
    Player player = harness.createPlayer(package, true).value();
    const HarnessFrame frame = harness.play(player, {0, 1}).value();
    const auto valueOf = [&](IntegerInput::Kind kind, std::uint32_t binding) {
      for (const IntegerValue& one : assignment)
        if (one.input.kind == kind && one.input.binding == binding) return one.value;
      return 99u;
    };
    const std::uint32_t item = valueOf(IntegerInput::Kind::kPushConstants, 0);
    const std::array<std::uint32_t, 4> expected = {valueOf(IntegerInput::Kind::kBlock, 0), valueOf(IntegerInput::Kind::kVarying, 0), item,
                                                   (valueOf(IntegerInput::Kind::kBlock, 1) + item) % 4};
    std::size_t covered = 0;
    for (std::size_t pixel = 0; pixel < frame.depth.size(); ++pixel) {
      float depth = 0;
      std::memcpy(&depth, &frame.depth[pixel], 4);
      if (depth >= 1) continue;
      ++covered;
      for (std::size_t channel = 0; channel < 4; ++channel) {
        float found = 0;
        std::memcpy(&found, &frame.colors[0][pixel * 4 + channel], 4);
        ASSERT_NEAR(found, static_cast<float>(expected[channel]), 0.01f) << channel;
      }
    }
    EXPECT_GT(covered, 100u);
  }
}

}  // namespace
}  // namespace reprise
