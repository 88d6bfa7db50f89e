// Every strategy of the registry on every shipped shader: sound recipes, valid modules, the same bytes every time.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compiler/source/validate.h"
#include "compiler/strategies/build_package.h"
#include "runtime/package/package.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

constexpr StateLimits kAllows = {true, true, true};

struct SubjectOfStrategies {
  ShaderProgram program;
  std::vector<Candidate> candidates;

  const Candidate& first() const { return candidates.front(); }
};

SubjectOfStrategies subjectOf(const std::string& file) {
  SubjectOfStrategies subject{shippedProgram(file), {}};
  subject.candidates = enumerateCandidates(*subject.program.fragment, subject.program.analysis, subject.program.sources, {});
  REPRISE_CHECK(!subject.candidates.empty() && subject.first().kept(), file);
  return subject;
}

// Integers are fetched nearest, whatever is tried with other payloads.
Filter filterFor(const Candidate& candidate, Filter filter) { return isInteger(candidate.scalar) ? Filter::kNearest : filter; }

// A refusal that is right: a depth prepass of a shader that discards, a repair of one that discards or takes derivatives, or
// that has too many outputs and inputs.
bool rightlyRefused(const Strategy& strategy, const ShaderProgram& program, const Error& error) {
  if (repairs(strategy) && error.code == "state.targets") return true;
  if (repairs(strategy) && program.analysis.takes_derivatives) return error.code == "repair.derivatives";
  if (repairs(strategy) && program.analysis.discards) return error.code == "repair.discards";
  return strategy.name == "original_prepass" && program.analysis.discards && error.code == "state.prepass_discards";
}

class StrategyOn : public testing::TestWithParam<std::string> {};

// Of pairs of eyes only the first is fetched from: the second writes no payload, and one image is enough.
TEST(Pairs, StoreInFramesThatAreWhollyDueAlone) {
  const SubjectOfStrategies subject = subjectOf(std::string(REPRISE_SOURCE_DIR) + "/shaders/marble/marble.frag");
  for (const char* strategy : {"branch", "two_pass", "two_pass_objects", "two_pass_stencil", "repair"}) {
    SCOPED_TRACE(strategy);
    VariantOptions options;
    options.strategy = strategy;
    options.pattern = PatternKind::kWhole;
    options.previous = PreviousImage::kOtherEye;
    options.period_frames = 2;
    const Result<Package> package = buildPackage(subject.program, subject.first(), options, kAllows);
    ASSERT_TRUE(package.ok()) << formatError(package.error());
    for (const Resource& resource : package->variant.resources)
      EXPECT_EQ(resource.lifetime, resource.name.starts_with("kept") ? Lifetime::kFrame : Lifetime::kPersistent) << resource.name;
    for (const Pass& pass : package->variant.passes) {
      const bool stores = std::any_of(pass.colors.begin(), pass.colors.end(), [](const ColorAttachment& color) { return color.resource == payloadTarget(0); });
      EXPECT_EQ(stores, pass.name == "store") << pass.name;
      EXPECT_EQ(pass.frames, stores ? PassFrames::kWhollyDue : PassFrames::kNotWhollyDue) << pass.name;
    }
  }
}

TEST(StrategyTwoPassObjects, DrawsAgainWhatItsMissesFlagOverWhatItsHitsWrote) {
  const SubjectOfStrategies subject = subjectOf(std::string(REPRISE_SOURCE_DIR) + "/shaders/marble/marble.frag");
  VariantOptions options;
  options.strategy = "two_pass_objects";
  const Package package = buildPackage(subject.program, subject.first(), options, kAllows).value();
  const Recipe& recipe = package.variant;
  EXPECT_EQ(recipe.flags, MissFlagging::kDraws);
  EXPECT_TRUE(recipe.requirements.conditional_rendering && recipe.requirements.fragment_stores);
  ASSERT_EQ(recipe.passes.size(), 2u);
  const Pass &hits = recipe.passes[0], &misses = recipe.passes[1];
  EXPECT_EQ(hits.objects, PassObjects::kAll);
  EXPECT_EQ(hits.frames, PassFrames::kAll) << "in a frame that is wholly due nothing would be flagged";
  EXPECT_EQ(misses.objects, PassObjects::kFlagged);
  EXPECT_NE(misses.rendering, hits.rendering) << "the flags are visible between renderings only";
  EXPECT_FALSE(misses.depth_clear);
  for (const ColorAttachment& color : misses.colors)
    if (!color.resource.empty()) {
      EXPECT_EQ(color.load, LoadOp::kLoad) << color.resource;
    }
  const Module flagging = readModule(package.modules.at(hits.fragment_module)).value();
  int atomics = 0, kills = 0;
  for (const Function& function : flagging.functions) {
    atomics += countOf(function, spv::Op::OpAtomicOr);
    kills += countOf(function, spv::Op::OpKill) + countOf(function, spv::Op::OpTerminateInvocation);
  }
  EXPECT_EQ(atomics, 1);
  EXPECT_EQ(kills, 1);
}

TEST_P(StrategyOn, GivesValidModulesAndAConsistentPackage) {
  const SubjectOfStrategies subject = subjectOf(GetParam());
  for (const Strategy& strategy : strategies())
    for (const std::string copy : {"shipped", "instrumented", "aged"}) {
      SCOPED_TRACE(strategy.name + " " + copy);
      VariantOptions options;
      options.strategy = strategy.name;
      options.instrumented = copy != "shipped";
      options.aged = copy == "aged";
      options.filter = filterFor(subject.first(), options.filter);
      const Result<Package> package = buildPackage(subject.program, subject.first(), options, kAllows);
      if (!package.ok() && rightlyRefused(strategy, subject.program, package.error())) continue;
      ASSERT_TRUE(package.ok()) << formatError(package.error());
      for (const auto& [name, words] : package->modules) {
        const Result<void> valid = validateModule(words);
        EXPECT_TRUE(valid.ok()) << name << ": " << valid.error().message;
      }
      const Result<void> consistent = checkPackage(*package);
      EXPECT_TRUE(consistent.ok()) << formatError(consistent.error());
    }
}

TEST_P(StrategyOn, EncodingsPatternsAndFiltersAllGiveConsistentPackages) {
  const SubjectOfStrategies subject = subjectOf(GetParam());
  for (const Encoding encoding : {Encoding::kRgba8, Encoding::kRgba16, Encoding::kRgba16f, Encoding::kRgba32f})
    for (const PatternKind pattern : kPatternKinds) {
      VariantOptions options;
      options.strategy = "branch";
      options.encoding = encoding;
      options.pattern = pattern;
      options.filter = filterFor(subject.first(), pattern == PatternKind::kTiled ? Filter::kNearest : Filter::kBilinear);
      options.instrumented = true;
      const Result<Package> package = buildPackage(subject.program, subject.first(), options, kAllows);
      ASSERT_TRUE(package.ok()) << nameOf(encoding) << " " << nameOf(pattern) << ": " << formatError(package.error());
      EXPECT_TRUE(checkPackage(*package).ok());
    }
}

TEST_P(StrategyOn, EveryKeptCandidateCanBeCached) {
  const SubjectOfStrategies subject = subjectOf(GetParam());
  for (const Candidate& candidate : subject.candidates) {
    if (!candidate.kept()) break;
    VariantOptions options;
    options.filter = filterFor(candidate, options.filter);
    const Result<BuiltRecipe> built = buildRecipe(subject.program, candidate, options, kAllows);
    ASSERT_TRUE(built.ok()) << candidate.id << ": " << formatError(built.error());
    ASSERT_EQ(built->recipe.payload.size(), candidate.values.size());
    for (std::size_t i = 0; i < candidate.values.size(); ++i) {
      EXPECT_EQ(built->recipe.payload[i].type, candidate.values[i].type);
      EXPECT_EQ(built->recipe.payload[i].line, candidate.values[i].place.line);
      EXPECT_EQ(built->recipe.payload[i].first_channel, candidate.values[i].first_channel);
    }
  }
}

TEST_P(StrategyOn, TwoBuildsOfAVariantAreTheSameBytes) {
  const SubjectOfStrategies one = subjectOf(GetParam()), two = subjectOf(GetParam());
  for (const char* strategy : {"branch", "three_pass"}) {
    VariantOptions options;
    options.strategy = strategy;
    options.instrumented = true;
    options.filter = filterFor(one.first(), options.filter);
    const Package first = buildPackage(one.program, one.first(), options, kAllows).value();
    const Package second = buildPackage(two.program, two.first(), options, kAllows).value();
    EXPECT_EQ(first.modules, second.modules) << strategy;
    EXPECT_EQ(recipeToJson(first.variant), recipeToJson(second.variant)) << strategy;
  }
}

INSTANTIATE_TEST_SUITE_P(Strategies, StrategyOn, testing::ValuesIn(shippedFragmentShaders()),
                         [](const auto& parameter) { return stemOf(parameter.param); });

// A shader with so many outputs, and its candidates.
SubjectOfStrategies subjectWithOutputs(int count) {
  std::string outputs, body;
  for (int i = 0; i < count; ++i) {
    outputs += "layout(location = " + std::to_string(i) + ") out vec4 color" + std::to_string(i) + ";\n";
    body += "  color" + std::to_string(i) + " = vec4(sin(place * " + std::to_string(i + 2) + ".0), 1.0);\n";
  }
  const CompiledShader fragment =
      compiled("#version 450\nlayout(location = 0) in vec3 place;\n" + outputs + "void main() {\n" + body + "}\n", "test.frag");
  const CompiledShader vertex = compiled("#version 450\nlayout(location = 0) in vec3 position;\nlayout(location = 0) out vec3 place;\n"
                                         "void main() { place = position; gl_Position = vec4(position, 1.0); }\n", "test.vert");
  SubjectOfStrategies subject{readProgram(vertex, fragment).value(), {}};
  CandidateOptions all;
  all.least_share = 0;
  subject.candidates = enumerateCandidates(*subject.program.fragment, subject.program.analysis, subject.program.sources, all);
  REPRISE_CHECK(subject.first().kept(), count);
  return subject;
}

TEST(Recipe, MoreColourTargetsThanDevicesHaveAreRefused) {
  const SubjectOfStrategies subject = subjectWithOutputs(8);
  const auto built = buildRecipe(subject.program, subject.first(), {}, {true, true});
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().code, "state.targets");
}

TEST(Recipe, AgesNeedNoColourTargetOfTheirOwn) {
  VariantOptions options;
  options.strategy = "branch";
  options.instrumented = options.aged = true;
  // Beside the outputs: one target of the payload, with its depth, and two that count.
  const SubjectOfStrategies subject = subjectWithOutputs(5);
  const Result<Package> package = buildPackage(subject.program, subject.first(), options, kAllows);
  ASSERT_TRUE(package.ok()) << formatError(package.error());
  EXPECT_TRUE(checkPackage(*package).ok());
  EXPECT_EQ(package->variant.requirements.color_attachments, static_cast<int>(kMostColorTargets));
}

TEST(Recipe, AgesAreOfTheCountingCopyAlone) {
  const SubjectOfStrategies subject = subjectOf(std::string(REPRISE_SOURCE_DIR) + "/shaders/marble/marble.frag");
  VariantOptions options, aged;
  aged.aged = true;
  EXPECT_EQ(recipeToJson(buildRecipe(subject.program, subject.first(), aged, kAllows)->recipe),
            recipeToJson(buildRecipe(subject.program, subject.first(), options, kAllows)->recipe));
}

TEST(Strategies, NamesAreUniqueAndFound) {
  std::set<std::string> names;
  for (const Strategy& strategy : strategies()) {
    EXPECT_TRUE(names.insert(strategy.name).second) << strategy.name;
    EXPECT_EQ(findStrategy(strategy.name), &strategy);
    EXPECT_FALSE(strategy.description.empty());
    EXPECT_FALSE(strategy.passes.empty());
  }
  EXPECT_EQ(findStrategy("branchy"), nullptr);
}

const SubjectOfStrategies& straightLine() {
  static const SubjectOfStrategies subject = subjectOf(std::string(REPRISE_SOURCE_DIR) + "/shaders/laws/straight_line/straight_line.frag");
  return subject;
}

std::string refusalOf(const std::string& strategy, const StateLimits& limits) {
  VariantOptions options;
  options.strategy = strategy;
  const Result<BuiltRecipe> built = buildRecipe(straightLine().program, straightLine().first(), options, limits);
  return built.ok() ? "" : built.error().code;
}

TEST(Strategies, WhatTheStateForbidsIsRefused) {
  for (const Strategy& strategy : strategies()) {
    const StateLimits none = {false, false, false};
    const std::string expected = strategy.rejects_by_depth ? "state.depth_compare" : strategy.needs_stencil ? "state.no_stencil"
                                 : repairs(strategy)       ? "state.shared_inputs" : "";
    EXPECT_EQ(refusalOf(strategy.name, none), expected) << strategy.name;
  }
  EXPECT_EQ(refusalOf("two_pass_objects", {true, true, true, false}), "state.one_draw");
  EXPECT_EQ(refusalOf("branchy", kAllows), "strategy.unknown");
}

const Candidate& integerPayload(const SubjectOfStrategies& subject) {
  const auto found = std::find_if(subject.candidates.begin(), subject.candidates.end(),
                                  [](const Candidate& candidate) { return candidate.name == "key"; });
  REPRISE_CHECK(found != subject.candidates.end() && found->kept(), "key");
  return *found;
}

TEST(Strategies, AnIntegerPayloadIsFetchedNearestOnlyAndKeptInAUintFormat) {
  const SubjectOfStrategies subject = subjectOf(std::string(REPRISE_SOURCE_DIR) + "/shaders/laws/integer/integer.frag");
  const Candidate& key = integerPayload(subject);
  EXPECT_EQ(key.type, "ivec2");
  for (const Strategy& strategy : strategies()) {
    VariantOptions options;
    options.strategy = strategy.name;
    options.filter = Filter::kBilinear;
    const Result<BuiltRecipe> refused = buildRecipe(subject.program, key, options, kAllows);
    EXPECT_EQ(refused.ok() ? "" : refused.error().code, strategy.caches ? "filter.integer" : "") << strategy.name;
    options.filter = Filter::kNearest;
    const Result<BuiltRecipe> built = buildRecipe(subject.program, key, options, kAllows);
    ASSERT_TRUE(built.ok()) << strategy.name << ": " << formatError(built.error());
    EXPECT_FALSE(built->recipe.requirements.linear_filter);
    if (built->recipe.resources.empty()) continue;
    EXPECT_EQ(built->recipe.resources[0].format, ResourceFormat::kRg32Uint);
    EXPECT_EQ(built->recipe.resources[0].clear, (std::array<float, 4>{}));
    EXPECT_EQ(built->recipe.resources[1].format, ResourceFormat::kR32Sfloat) << "depth";
  }
}

TEST(Strategies, AShaderWithSideEffectsIsRefusedByAllThatCacheAndPlayedByTheOriginal) {
  const char* vertex = "#version 450\nlayout(location = 0) in vec4 position;\nlayout(location = 0) out vec4 p;\n"
                       "void main() { p = position; gl_Position = position; }\n";
  const char* fragment = "#version 450\nlayout(set = 0, binding = 0) buffer Log { vec4 last; } log_;\nlayout(location = 0) in vec4 p;\n"
                         "layout(location = 0) out vec4 color;\nvoid main() { log_.last = p; color = sin(exp(p)); }\n";
  const ShaderProgram program = readProgram(compiled(vertex, "test.vert"), compiled(fragment)).value();
  for (const Strategy& strategy : strategies()) {
    VariantOptions options;
    options.strategy = strategy.name;
    const Result<BuiltRecipe> built = buildRecipe(program, {}, options, kAllows);
    EXPECT_EQ(built.ok(), !strategy.caches) << strategy.name;
    if (built.ok()) continue;
    EXPECT_EQ(built.error().code, "shader.side_effects");
  }
}

TEST(Strategies, TheOriginalIsTheShaderAsCompiled) {
  VariantOptions options;
  options.strategy = "original";
  const BuiltRecipe built = buildRecipe(straightLine().program, straightLine().first(), options, kAllows).value();
  EXPECT_EQ(built.modules.at("vertex"), straightLine().program.vertex_words);
  EXPECT_EQ(built.modules.at("fragment"), straightLine().program.fragment_words);
  EXPECT_FALSE(built.recipe.uses_reprise_set);
  EXPECT_TRUE(built.recipe.resources.empty());
}

TEST(Strategies, ShippedModulesHaveNoLinesAndNoSource) {
  const BuiltRecipe built = buildRecipe(straightLine().program, straightLine().first(), {}, kAllows).value();
  for (const auto& [name, words] : built.modules) {
    const Module module = readModule(words).value();
    EXPECT_TRUE(module.debug_sources.empty()) << name;
    for (const Function& function : module.functions)
      for (const Block& block : function.blocks)
        for (const Instruction& instruction : block.instructions)
          if (instruction.line != LineMark{}) ADD_FAILURE() << name << " has a line";
  }
}

TEST(Strategies, RepriseTakesTheFirstSetThatTheShadersLeaveFree) {
  const BuiltRecipe built = buildRecipe(straightLine().program, straightLine().first(), {}, kAllows).value();
  std::uint32_t highest = 0;
  for (const Descriptor& descriptor : straightLine().program.interface.descriptors) highest = std::max(highest, descriptor.set);
  EXPECT_EQ(built.recipe.reprise_set, highest + 1);
}

TEST(CacheLayout, RangesComeBackFromTheConstantsTheyMade) {
  ValueRanges ranges;
  ranges.depth_near = 0.5f;
  ranges.depth_far = 20;
  ranges.payload_min = {-1, 0, 0.25f, 0};
  ranges.payload_max = {2, 1, 0.75f, 4};
  VariantOptions options;
  options.encoding = Encoding::kRgba8;
  options.ranges = ranges;
  const BuiltRecipe built = buildRecipe(straightLine().program, straightLine().first(), options, kAllows).value();
  options.ranges = rangesOf(built.recipe);
  const BuiltRecipe again = buildRecipe(straightLine().program, straightLine().first(), options, kAllows).value();
  EXPECT_NEAR(options.ranges.depth_near, ranges.depth_near, 1e-4);
  EXPECT_NEAR(options.ranges.depth_far, ranges.depth_far, 1e-3);
  for (int i = 0; i < built.recipe.payload.front().channels; ++i) {
    EXPECT_NEAR(again.recipe.constants.payload_scale[i], built.recipe.constants.payload_scale[i], 1e-4) << i;
    EXPECT_NEAR(again.recipe.constants.payload_offset[i], built.recipe.constants.payload_offset[i], 1e-4) << i;
  }
}

TEST(CacheLayout, IntegersLieInUintFormatsWhateverTheEncoding) {
  const ResourceFormat expected[] = {ResourceFormat::kR32Uint, ResourceFormat::kRg32Uint, ResourceFormat::kRgba32Uint,
                                     ResourceFormat::kRgba32Uint};
  for (const Encoding encoding : {Encoding::kRgba8, Encoding::kRgba16, Encoding::kRgba16f, Encoding::kRgba32f})
    for (int channels = 1; channels <= 4; ++channels) {
      const CacheLayout layout = cacheLayout(channels, encoding, true);
      EXPECT_EQ(layout.payload_formats, std::vector<ResourceFormat>{expected[channels - 1]});
      EXPECT_FALSE(layout.depth_in_alpha || layout.affine || layout.narrow);
      EXPECT_EQ(layout.bytes_per_pixel, bytesPerPixel(expected[channels - 1]) + 4);
    }
}

TEST(CacheLayout, DepthHasAnImageOfItsOwnWhereAlphaIsTakenOrHasEightBits) {
  for (int channels = 1; channels <= 4; ++channels) {
    EXPECT_FALSE(cacheLayout(channels, Encoding::kRgba8).depth_in_alpha) << channels;
    EXPECT_EQ(cacheLayout(channels, Encoding::kRgba16f).depth_in_alpha, channels < 4) << channels;
    EXPECT_EQ(cacheLayout(channels, Encoding::kRgba32f).depth_in_alpha, channels < 4) << channels;
  }
}

TEST(CacheLayout, SeveralTargetsShareOneDepthInTheLast) {
  const CacheLayout five = cacheLayout(5, Encoding::kRgba16f);
  EXPECT_EQ(five.payload_formats, (std::vector<ResourceFormat>{ResourceFormat::kRgba16Sfloat, ResourceFormat::kRg16Sfloat}));
  EXPECT_TRUE(five.narrow && five.depth_in_alpha);
  EXPECT_EQ(five.bytes_per_pixel, 8 + 4);
  const CacheLayout sixteen = cacheLayout(16, Encoding::kRgba8);
  EXPECT_EQ(sixteen.payload_formats, std::vector<ResourceFormat>(4, ResourceFormat::kRgba8Unorm));
  EXPECT_FALSE(sixteen.depth_in_alpha);
  EXPECT_EQ(sixteen.bytes_per_pixel, 4 * 4 + 2);
}

TEST(CacheLayout, GuardsAreStoredAsTheyAre) {
  ValueRanges ranges;
  ranges.payload_min.fill(3);
  ranges.payload_max.fill(5);
  const CacheConstants constants = encodingConstants(cacheLayout(4, Encoding::kRgba8), Encoding::kRgba8, Filter::kNearest, ranges, {3});
  EXPECT_NE(constants.payload_scale[0], 1);
  EXPECT_EQ(constants.payload_scale[3], 1);
  EXPECT_EQ(constants.payload_offset[3], 0);
}

}  // namespace
}  // namespace reprise
