// Law 6 for recipes and interfaces: what is written is what is read.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cstring>
#include <limits>

#include "runtime/package/package.h"

namespace reprise {
namespace {

template <typename T>
T oneOf(std::initializer_list<T> values) {
  return *rc::gen::elementOf(std::vector<T>(values));
}

bool anyBool() { return *rc::gen::arbitrary<bool>(); }
int anyInt() { return *rc::gen::arbitrary<int>(); }
std::uint32_t anyCount() { return *rc::gen::arbitrary<std::uint32_t>(); }

// Quotes, backslashes, control characters and letters of two bytes among others; valid UTF-8.
std::string anyText() {
  std::string text;
  for (int parts = *rc::gen::inRange(0, 5); parts > 0; --parts)
    text += oneOf({"a", "Z", "_", ".", "\"", "\\", "\n", " ", "\xc3\xa4", "\x01", "9"});
  return text;
}

// All floats by their bits but NaN, which equals nothing.
float anyFloat() {
  const float value = std::bit_cast<float>(anyCount());
  return value == value ? value : std::numeric_limits<float>::infinity();
}

std::array<float, 4> anyFloats() { return {anyFloat(), anyFloat(), anyFloat(), anyFloat()}; }

template <typename T, typename Make>
std::vector<T> some(Make make) {
  std::vector<T> list;
  for (int count = *rc::gen::inRange(0, 4); count > 0; --count) list.push_back(make());
  return list;
}

Resource anyResource() {
  return {anyText(),
          oneOf({ResourceFormat::kRgba8Unorm, ResourceFormat::kRg16Unorm, ResourceFormat::kRgba16Unorm, ResourceFormat::kRg16Sfloat, ResourceFormat::kRgba16Sfloat, ResourceFormat::kRgba32Sfloat,
                 ResourceFormat::kR32Uint, ResourceFormat::kRg32Uint, ResourceFormat::kRgba32Uint,
                 ResourceFormat::kR8Unorm, ResourceFormat::kR16Sfloat, ResourceFormat::kR32Sfloat}),
          anyFloat(), oneOf({Lifetime::kFrame, Lifetime::kHistory, Lifetime::kPersistent}), anyFloats()};
}

ColorAttachment anyColor() {
  return {anyInt(), anyText(), oneOf({LoadOp::kClear, LoadOp::kLoad, LoadOp::kDontCare}),
          oneOf({BlendKind::kReplace, BlendKind::kAdd}), anyInt()};
}

Read anyRead() { return {anyText(), anyCount(), oneOf({Filter::kNearest, Filter::kBilinear}), anyBool()}; }

Pass anyPass() {
  return {anyText(), oneOf({PassKind::kDraw, PassKind::kTiles, PassKind::kDispatch, PassKind::kFullScreen}), anyInt(), anyText(), anyText(),
          some<ColorAttachment>(anyColor), anyBool(), oneOf({DepthUse::kAsApp, DepthUse::kEqualNoWrite, DepthUse::kNone}),
          oneOf({StencilUse::kNone, StencilUse::kMarkIfZero}), some<Read>(anyRead), oneOf({PassFrames::kAll, PassFrames::kWhollyDue, PassFrames::kNotWhollyDue}),
          oneOf({PassObjects::kAll, PassObjects::kFlagged})};
}

PreviousInput anyPrevious() {
  return {oneOf({PreviousSource::kUniformBlock, PreviousSource::kPushConstants}), anyText(), anyCount(), anyCount(), anyCount(), anyCount()};
}

PayloadValue anyPayload() {
  return {anyText(), anyText(), anyText(), anyInt(), anyInt(), anyInt(), anyInt(),
          anyInt(),  anyFloats(), anyFloats(), some<std::string>(anyText)};
}

CacheConstants anyConstants() {
  CacheConstants constants;
  for (float(*vector)[4] : {&constants.depth_range, &constants.tolerance, &constants.payload_range})
    for (float& value : *vector) value = anyFloat();
  for (ChannelFloats* channels : {&constants.payload_scale, &constants.payload_offset, &constants.free_payload})
    for (float& value : *channels) value = anyFloat();
  return constants;
}

Recipe anyRecipe() {
  Recipe recipe;
  recipe.strategy = anyText();
  recipe.pattern = oneOf({PatternKind::kTiled, PatternKind::kRandom, PatternKind::kInterleaved, PatternKind::kWhole});
  recipe.block_pixels = anyCount();
  recipe.filter = oneOf({Filter::kNearest, Filter::kBilinear});
  recipe.encoding = oneOf({Encoding::kRgba8, Encoding::kRgba16, Encoding::kRgba16f, Encoding::kRgba32f});
  recipe.period_frames = oneOf({kNeverRefresh, 1u, 64u});
  recipe.previous = oneOf({PreviousImage::kLastFrame, PreviousImage::kOtherEye});
  recipe.payload = some<PayloadValue>(anyPayload);
  recipe.requirements = {anyBool(), anyBool(), anyBool(), anyBool(), anyInt(), anyBool(), anyBool(), anyBool(), anyBool()};
  recipe.reprise_set = anyCount();
  recipe.uses_reprise_set = anyBool();
  recipe.flags = oneOf({MissFlagging::kNone, MissFlagging::kTiles, MissFlagging::kDraws});
  recipe.orthographic = anyBool();
  recipe.constants = anyConstants();
  recipe.resources = some<Resource>(anyResource);
  recipe.passes = some<Pass>(anyPass);
  recipe.modules = some<ModuleEntry>([] { return ModuleEntry{anyText(), anyText(), anyText()}; });
  recipe.previous_inputs = some<PreviousInput>(anyPrevious);
  return recipe;
}

ScalarKind anyScalar() { return oneOf({ScalarKind::kFloat, ScalarKind::kInt, ScalarKind::kUint}); }

BlockMember anyMember() {
  return {anyText(), anyScalar(), anyInt(), anyInt(), anyCount(), anyCount(), anyBool(), anyCount(), anyCount()};
}

Descriptor anyDescriptor() {
  return {anyText(), anyCount(), anyCount(), anyCount(),
          oneOf({DescriptorKind::kUniformBlock, DescriptorKind::kStorageBlock, DescriptorKind::kCombinedImageSampler,
                 DescriptorKind::kSampledImage, DescriptorKind::kSampler, DescriptorKind::kStorageImage,
                 DescriptorKind::kUniformTexelBuffer, DescriptorKind::kStorageTexelBuffer}),
          oneOf({ImageDimension::kNone, ImageDimension::k1D, ImageDimension::k2D, ImageDimension::k3D, ImageDimension::kCube,
                 ImageDimension::k1DArray, ImageDimension::k2DArray, ImageDimension::kCubeArray}),
          anyCount(), anyCount(), some<BlockMember>(anyMember), anyScalar(), anyBool(), anyBool(), anyText()};
}

ShaderInterface anyInterface() {
  ShaderInterface interface;
  interface.vertex_inputs = some<VertexInput>([] { return VertexInput{anyText(), anyCount(), anyScalar(), anyInt()}; });
  interface.outputs = some<FragmentOutput>([] { return FragmentOutput{anyText(), anyCount(), anyScalar(), anyInt()}; });
  interface.descriptors = some<Descriptor>(anyDescriptor);
  interface.push_constant_name = anyText();
  interface.push_constants = some<PushConstantRange>([] { return PushConstantRange{anyCount(), anyCount(), anyCount()}; });
  interface.push_constant_members = some<BlockMember>(anyMember);
  interface.writes_depth = anyBool();
  interface.discards = anyBool();
  return interface;
}

RC_GTEST_PROP(RoundTrip, KeepsRecipes, ()) {
  const Recipe recipe = anyRecipe();
  const Result<Recipe> read = recipeFromJson(recipeToJson(recipe));
  RC_ASSERT(read.ok());
  RC_ASSERT(read->strategy == recipe.strategy && read->pattern == recipe.pattern && read->filter == recipe.filter);
  RC_ASSERT(read->block_pixels == recipe.block_pixels && read->period_frames == recipe.period_frames);
  RC_ASSERT(read->encoding == recipe.encoding && read->payload == recipe.payload && read->requirements == recipe.requirements);
  RC_ASSERT(read->reprise_set == recipe.reprise_set && read->uses_reprise_set == recipe.uses_reprise_set);
  // Bit for bit: 0 and -0 are equal to the comparison of floats.
  RC_ASSERT(std::memcmp(&read->constants, &recipe.constants, sizeof(CacheConstants)) == 0);
  RC_ASSERT(read->resources == recipe.resources && read->passes == recipe.passes && read->modules == recipe.modules);
  RC_ASSERT(read->previous_inputs == recipe.previous_inputs && read->format_version == recipe.format_version);
  RC_ASSERT(read->flags == recipe.flags);
  RC_ASSERT(read->orthographic == recipe.orthographic && read->previous == recipe.previous);
}

RC_GTEST_PROP(RoundTrip, KeepsInterfaces, ()) {
  const ShaderInterface interface = anyInterface();
  const Result<ShaderInterface> read = interfaceFromJson(interfaceToJson(interface));
  RC_ASSERT(read.ok());
  RC_ASSERT(*read == interface);
}

TEST(RoundTrip, NotANumberStaysOne) {
  Recipe recipe;
  recipe.constants.free_payload[2] = std::numeric_limits<float>::quiet_NaN();
  const Result<Recipe> read = recipeFromJson(recipeToJson(recipe));
  ASSERT_TRUE(read.ok());
  EXPECT_NE(read->constants.free_payload[2], read->constants.free_payload[2]);
}

TEST(RoundTrip, NamesThatAreNoUtf8DoNotStopTheWriter) {
  Recipe recipe;
  recipe.strategy = "\xff\xfe";
  EXPECT_TRUE(recipeFromJson(recipeToJson(recipe)).ok());
}

// Whatever is cut out of a recipe or put into it, the reader answers, and what it accepts it can write again.
RC_GTEST_PROP(RoundTrip, DamagedTextNeverCrashes, ()) {
  std::string text = recipeToJson(anyRecipe());
  for (int edits = *rc::gen::inRange(1, 4); edits > 0; --edits) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    text.replace(at, *rc::gen::inRange<std::size_t>(0, 8), oneOf({"", "\"", "-1", "1e999", "[", "{", "null", "3.5"}));
  }
  const Result<Recipe> read = recipeFromJson(text);
  if (read.ok()) RC_ASSERT(recipeFromJson(recipeToJson(*read)).ok());
  else RC_ASSERT(read.error().code == "package.manifest");
}

}  // namespace
}  // namespace reprise
