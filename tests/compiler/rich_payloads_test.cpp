// Payloads beyond one value that is always computed: several values, guarded ones, parts of chains.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/candidates/groups.h"
#include "compiler/source/validate.h"
#include "compiler/strategies/payload_bodies.h"
#include "compiler/transforms/regroup.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

constexpr std::uint32_t kSin = 13, kExp = 27;

constexpr const char* kHead =
    "#version 450\n"
    "layout(location = 0) in vec4 p;\n"
    "layout(location = 1) in vec4 q;\n"
    "layout(set = 0, binding = 0) uniform Scene { float time; vec4 camera; } scene;\n"
    "layout(location = 0) out vec4 color;\n";

std::string shaderOf(const std::string& body) { return std::string(kHead) + "void main() {\n" + body + "\n}\n"; }

const Candidate* findKept(const AnalysedShader& shader, bool (*wanted)(const Candidate&)) {
  for (const Candidate& candidate : shader.candidates)
    if (candidate.kept() && wanted(candidate)) return &candidate;
  return nullptr;
}

// Two dear values that the tail joins with something that changes: each saves half, both all of it.
const std::string kTwoDear = shaderOf(
    "vec3 base = sin(exp(sin(p.xyz * 3.0)) + exp(p.yzx));\n"
    "float gloss = exp(sin(exp(p.w)) * exp(p.x)) * exp(cos(p.y));\n"
    "color = vec4(base * dot(scene.camera, q), pow(q.x, gloss) * scene.camera.x);");

TEST(Groups, TheMinimumCutFindsTheValuesThatSaveMostTogether) {
  const auto shader = analysed(kTwoDear);
  const Candidate* group = findKept(*shader, [](const Candidate& one) { return one.name == "base + gloss"; });
  ASSERT_NE(group, nullptr);
  EXPECT_EQ(group->type, "vec3 + float");
  EXPECT_EQ(group->values[0].first_channel, 0);
  EXPECT_EQ(group->values[1].first_channel, 3);
  EXPECT_GT(group->saved_cost, std::max(shader->named("base").saved_cost, shader->named("gloss").saved_cost));
}

TEST(Groups, NoOtherPairSavesMore) {
  const auto shader = analysedWhole(kTwoDear);
  std::vector<Candidate> singles;
  for (const Candidate& candidate : shader->candidates)
    if (candidate.values.size() == 1 && !isRegrouped(candidate)) singles.push_back(candidate);
  // What was pruned for others' sake can stand in a group all the same.
  for (Candidate& single : singles)
    if (single.dropped.code.starts_with("pruned.")) single.dropped = {};
  GroupOptions options;
  const auto saved = [&](const std::vector<std::size_t>& group) {
    std::vector<int> cuts;
    for (const std::size_t single : group) cuts.push_back(singles[single].values.front().node);
    return shader->analysis.total_cost - costOf(shader->analysis.graph, neededNodes(shader->analysis.graph, {}, cuts));
  };
  const auto channels = [&](const std::vector<std::size_t>& group) {
    int total = 0;
    for (const std::size_t single : group) total += singles[single].values.front().channels;
    return total;
  };
  int compared = 0;
  for (const std::vector<std::size_t>& group : findGroups(shader->analysis, singles, options)) {
    std::vector<int> inputs;
    for (std::size_t a = 0; a < singles.size(); ++a)
      for (std::size_t b = a + 1; b < singles.size(); ++b) {
        if (!singles[a].kept() || !singles[b].kept() || channels({a, b}) > channels(group)) continue;
        // Only those that the search for this group could have taken.
        const bool same_inputs = std::all_of(group.begin(), group.end(), [&](std::size_t one) {
          return singles[one].inputs == singles[group.front()].inputs;
        }) && singles[a].inputs == singles[group.front()].inputs && singles[b].inputs == singles[group.front()].inputs;
        if (!same_inputs) continue;
        ++compared;
        EXPECT_LE(saved({a, b}), saved(group) + 1e-6) << singles[a].id << " and " << singles[b].id;
      }
  }
  EXPECT_GT(compared, 10);
}

TEST(Groups, BodiesTakeAndHandOutEveryValue) {
  const auto shader = analysed(kTwoDear);
  const Candidate* group = findKept(*shader, [](const Candidate& one) { return one.name == "base + gloss"; });
  ASSERT_NE(group, nullptr);
  const PayloadBodies bodies = makeBodies(shader->shader, group->values, {true, true, true}).value();
  const Result<void> valid = validateModule(writeModule(bodies.module));
  EXPECT_TRUE(valid.ok()) << valid.error().message;
  EXPECT_EQ(countOfExtended(*findFunction(bodies.module, bodies.hit), kExp), 0);
  EXPECT_EQ(countOfExtended(*findFunction(bodies.module, bodies.hit), kSin), 0);
  EXPECT_EQ(countOf(*findFunction(bodies.module, bodies.miss), spv::Op::OpStore), 4 + 1) << "a store for each channel and the colour";
}

const std::string kRare = shaderOf(
    "color = q * exp(q.y);\n"
    "if (sin(q.x) > 0.5) {\n"
    "  float rare = exp(exp(exp(sin(p.x) * p.y) * p.z) * p.w);\n"
    "  color = vec4(rare * scene.camera);\n"
    "}");

TEST(Guards, AValueInConditionalCodeHasAChannelThatTellsWhetherItWasComputed) {
  const auto shader = analysedWhole(kRare);
  const Candidate& rare = shader->named("rare");
  EXPECT_TRUE(rare.conditional);
  EXPECT_EQ(rare.values.front().guard_channel, 1);
  EXPECT_EQ(rare.channels, 2);
}

TEST(Guards, ValuesOfOneBlockShareTheirs) {
  const auto shader = analysed(shaderOf("color = q * exp(q.y);\n"
                                        "if (q.x > 0.5) {\n"
                                        "  vec2 rare = sin(exp(exp(p.xy)) * exp(p.zw) + exp(p.yx));\n"
                                        "  float seldom = exp(exp(p.z) * exp(p.w) + exp(sin(exp(p.x))));\n"
                                        "  color = vec4(rare * scene.camera.xy, seldom * scene.camera.z, pow(seldom, rare.x * scene.camera.w));\n"
                                        "}"));
  const Candidate* group = findKept(*shader, [](const Candidate& one) { return one.values.size() == 2 && one.conditional; });
  ASSERT_NE(group, nullptr);
  EXPECT_EQ(group->values[0].guard_channel, 3);
  EXPECT_EQ(group->values[1].guard_channel, 3);
  EXPECT_EQ(group->channels, 4);
}

TEST(Guards, TheWantsBodyComputesTheConditionAlone) {
  const auto shader = analysedWhole(kRare);
  const PayloadBodies bodies = makeBodies(shader->shader, shader->named("rare").values, {true, true, true, true}).value();
  const Result<void> valid = validateModule(writeModule(bodies.module));
  EXPECT_TRUE(valid.ok()) << valid.error().message;
  const Function& wants = *findFunction(bodies.module, bodies.wants);
  EXPECT_EQ(countOfExtended(wants, kSin), 1);
  EXPECT_EQ(countOfExtended(wants, kExp), 0);
  EXPECT_EQ(countOf(wants, spv::Op::OpStore), 1) << "the bit";
}

TEST(Guards, TheWantsBodyDiscardsNothing) {
  const auto shader = analysedWhole(shaderOf("if (q.y > 0.9) discard;\ncolor = q;\n"
                                             "if (q.x > 0.5) { float rare = exp(exp(sin(p.x))); color = vec4(rare * scene.camera); }"));
  const PayloadBodies bodies = makeBodies(shader->shader, shader->named("rare").values, {true, true, true, true}).value();
  EXPECT_EQ(countOf(*findFunction(bodies.module, bodies.wants), spv::Op::OpKill), 0);
  EXPECT_EQ(countOf(*findFunction(bodies.module, bodies.hit), spv::Op::OpKill), 1);
}

std::vector<Chain> chainsOf(const AnalysedShader& shader) {
  return findChains(shader.shader.module, *findFunction(shader.shader.module, shader.shader.entry_function));
}

TEST(Chains, AreTheLargestTreesOfOneOperation) {
  struct Case {
    const char* body;
    ChainKind kind;
    std::size_t terms;
    std::vector<bool> negative;
  };
  const Case cases[] = {
      {"color = vec4(sin(p.x) + (sin(p.y) - sin(p.z)) - sin(p.w));", ChainKind::kSum, 4, {false, false, true, true}},
      {"color = vec4(sin(p.x) - (sin(p.y) - sin(p.z)));", ChainKind::kSum, 3, {false, true, false}},
      {"color = vec4(sin(p.x) * sin(p.y) * sin(p.z) * sin(p.w));", ChainKind::kProduct, 4, {false, false, false, false}},
      {"color = vec4(min(min(sin(p.x), sin(p.y)), min(sin(p.z), 0.5)));", ChainKind::kMinimum, 4, {false, false, false, false}},
      {"color = vec4(max(max(sin(p.x), sin(p.y)), sin(p.z)));", ChainKind::kMaximum, 3, {false, false, false}}};
  for (const Case& one : cases) {
    const auto shader = analysedWhole(shaderOf(one.body));
    const std::vector<Chain> chains = chainsOf(*shader);
    ASSERT_EQ(chains.size(), 1u) << one.body;
    EXPECT_EQ(chains[0].kind, one.kind) << one.body;
    ASSERT_EQ(chains[0].terms.size(), one.terms) << one.body;
    for (std::size_t i = 0; i < one.terms; ++i) EXPECT_EQ(chains[0].terms[i].negative, one.negative[i]) << one.body << " term " << i;
  }
}

TEST(Chains, EndWhereAResultIsUsedTwiceOrMustNotBeReordered) {
  EXPECT_TRUE(chainsOf(*analysedWhole(shaderOf("float two = sin(p.x) + sin(p.y);\ncolor = vec4(two + sin(p.z), two, 0.0, 1.0);"))).empty());
  EXPECT_TRUE(chainsOf(*analysedWhole(shaderOf("precise float sum = sin(p.x) + sin(p.y) + sin(p.z);\ncolor = vec4(sum);"))).empty());
}

const std::string kSum = shaderOf(
    "float sum = exp(sin(p.x)) + exp(sin(p.y)) + sin(scene.time + q.x) + exp(sin(p.z)) + exp(sin(p.w));\n"
    "color = sum * q;");

TEST(Partials, AChainIsSplitByWhatItsTermsDependOn) {
  const auto shader = analysed(kSum);
  const Candidate* part = findKept(*shader, [](const Candidate& one) { return isRegrouped(one) && !one.steadier_part; });
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(part->values.front().regrouping->kept, (std::vector<bool>{true, true, false, true, true}));
  EXPECT_EQ(inputNames(*part, shader->analysis), std::vector<std::string>{"varying p"});
  EXPECT_NE(part->id.find("[11011]"), std::string::npos) << part->id;
}

TEST(Partials, TheHeaviestTermCanBeLeftToTheTail) {
  const auto shader = analysed(shaderOf("float sum = 0.1 * exp(sin(p.x)) + 0.6 * exp(sin(p.y)) + 0.3 * exp(sin(p.z));\ncolor = sum * q;"));
  const Candidate* part = findKept(*shader, [](const Candidate& one) { return one.steadier_part; });
  ASSERT_NE(part, nullptr) << "though the whole sum saves more";
  EXPECT_EQ(part->values.front().regrouping->kept, (std::vector<bool>{true, false, true}));
}

TEST(Partials, TheHitBodyComputesTheOtherTermsAndTheMissBodyKeepsTheOrder) {
  const auto shader = analysed(kSum);
  const Candidate* part = findKept(*shader, [](const Candidate& one) { return isRegrouped(one) && !one.steadier_part; });
  ASSERT_NE(part, nullptr);
  const PayloadBodies bodies = makeBodies(shader->shader, part->values, {true, true, true}).value();
  const Result<void> valid = validateModule(writeModule(bodies.module));
  EXPECT_TRUE(valid.ok()) << valid.error().message;
  const Function &hit = *findFunction(bodies.module, bodies.hit), &miss = *findFunction(bodies.module, bodies.miss);
  EXPECT_EQ(countOfExtended(hit, kExp), 0);
  EXPECT_EQ(countOfExtended(hit, kSin), 1);
  EXPECT_EQ(countOfExtended(miss, kExp), 4) << "terms are computed once";
  const Function& original = *findFunction(shader->shader.module, shader->shader.entry_function);
  EXPECT_EQ(countOf(miss, spv::Op::OpFAdd), countOf(original, spv::Op::OpFAdd) + 3) << "the chain as it was, and the part beside it";
}

// A variable that is read by component in a condition once stayed in memory, and every read of it depended on every write.
TEST(Candidates, AVariableReadByComponentIsPromoted) {
  const auto shader = analysedWhole(shaderOf("vec3 base = p.xyz;\nif (base.x > 0.2) base += exp(sin(q.x)) * q.zyx;\ncolor = vec4(base, 1.0);"));
  EXPECT_EQ(countOf(*findFunction(shader->shader.module, shader->shader.entry_function), spv::Op::OpVariable), 0);
}

TEST(Candidates, WhatDecidesADiscardIsNone) {
  const auto shader = analysedWhole(shaderOf("float cover = exp(sin(p.x));\nif (cover > 1.5) discard;\ncolor = q * exp(p.y);"));
  EXPECT_EQ(shader->named("cover").dropped.code, "value.coverage");
}

TEST(Candidates, WhatDecidesTheDepthIsNone) {
  const auto shader = analysedWhole(shaderOf("float height = exp(sin(p.x));\ngl_FragDepth = 0.5 * height;\ncolor = q * exp(height);"));
  EXPECT_EQ(shader->named("height").dropped.code, "value.coverage");
}

}  // namespace
}  // namespace reprise
