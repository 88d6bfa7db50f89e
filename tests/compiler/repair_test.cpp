// The strategy that repairs: what misses leave, how it is taken up again, and which shaders cannot be finished so.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/source/validate.h"
#include "compiler/strategies/build_recipe.h"
#include "compiler/strategies/kept_inputs.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

constexpr StateLimits kAllows = {true, true, true};

// A pair of shaders whose fragment side declares `inputs` and computes `work` (a vec4) from them and from the vec3 `place`.
struct Pair {
  std::string inputs, vertex_outputs, vertex_code, work;
};

ShaderProgram programOf(const Pair& pair) {
  const std::string head = "#version 450\n";
  const CompiledShader vertex =
      compiled(head + "layout(location = 0) in vec3 position;\nlayout(location = 0) out vec3 place;\n" + pair.vertex_outputs +
                   "void main() {\n  place = position;\n  " + pair.vertex_code + "\n  gl_Position = vec4(position, 1.0);\n}\n",
               "test.vert");
  const CompiledShader fragment = compiled(head + "layout(location = 0) in vec3 place;\n" + pair.inputs + "layout(location = 0) out vec4 color;\n" +
                                           "void main() {\n  vec4 work = sin(exp(sin(place.xyzx * 3.0))) + sin(cos(exp(place.yzxx)));\n  color = work * (" +
                                           pair.work + ");\n}\n");
  return readProgram(vertex, fragment).value();
}

Candidate workOf(const ShaderProgram& program) {
  const std::vector<Candidate> candidates = enumerateCandidates(*program.fragment, program.analysis, program.sources, {});
  REPRISE_CHECK(!candidates.empty() && candidates.front().kept(), candidates.size());
  return candidates.front();
}

Result<BuiltRecipe> repaired(const ShaderProgram& program, VariantOptions options = {}) {
  options.strategy = "repair";
  return buildRecipe(program, workOf(program), options, kAllows);
}

const Pair kPlain = {"layout(location = 1) in vec4 tint;\n", "layout(location = 1) out vec4 tint;\n", "tint = vec4(0.5);", "tint"};

std::string refusalOf(const Pair& pair) {
  const Result<BuiltRecipe> built = repaired(programOf(pair));
  return built.ok() ? "" : built.error().code;
}

std::vector<std::string> inputsOf(const Module& module) {
  std::vector<std::string> inputs;
  for (const Instruction& global : module.globals) {
    if (global.opcode != spv::Op::OpVariable || static_cast<spv::StorageClass>(global.word(0)) != spv::StorageClass::Input) continue;
    const auto built_in = decorationOf(module, global.result_id, spv::Decoration::BuiltIn);
    const auto location = decorationOf(module, global.result_id, spv::Decoration::Location);
    inputs.push_back(built_in ? "built-in " + std::to_string(*built_in) : "location " + std::to_string(location.value_or(99)));
  }
  std::sort(inputs.begin(), inputs.end());
  return inputs;
}

Module moduleNamed(const BuiltRecipe& built, const std::string& name) { return readModule(built.modules.at(name)).value(); }

bool hasMode(const Module& module, spv::ExecutionMode wanted) {
  return std::any_of(module.execution_modes.begin(), module.execution_modes.end(),
                     [&](const Instruction& mode) { return static_cast<spv::ExecutionMode>(mode.word(1)) == wanted; });
}

int kills(const Module& module) {
  int count = 0;
  for (const Function& function : module.functions) count += countOf(function, spv::Op::OpKill) + countOf(function, spv::Op::OpTerminateInvocation);
  return count;
}

TEST(StrategyRepair, OneDrawKeepsAllFragmentsAndTilesFinishTheMisses) {
  const BuiltRecipe built = repaired(programOf(kPlain)).value();
  ASSERT_EQ(built.recipe.passes.size(), 2u);
  const Pass &draw = built.recipe.passes[0], &tiles = built.recipe.passes[1];
  EXPECT_EQ(draw.kind, PassKind::kDraw);
  EXPECT_EQ(draw.depth, DepthUse::kAsApp);
  EXPECT_EQ(tiles.kind, PassKind::kTiles);
  EXPECT_EQ(tiles.depth, DepthUse::kNone);
  EXPECT_EQ(built.recipe.flags, MissFlagging::kTiles);
  const Module drawn = moduleNamed(built, draw.fragment_module), repair = moduleNamed(built, tiles.fragment_module);
  EXPECT_TRUE(hasMode(drawn, spv::ExecutionMode::EarlyFragmentTests)) << "hidden fragments would be shaded";
  EXPECT_EQ(kills(drawn), 0);
  EXPECT_EQ(kills(repair), 1) << "of pixels without a miss";
  EXPECT_FALSE(hasMode(repair, spv::ExecutionMode::EarlyFragmentTests));
}

TEST(StrategyRepair, TheRepairLoadsWhatItsPassBefore) {
  const BuiltRecipe built = repaired(programOf(kPlain)).value();
  for (const ColorAttachment& color : built.recipe.passes[1].colors)
    if (!color.resource.empty()) {
      EXPECT_EQ(color.load, LoadOp::kLoad) << color.resource;
    }
  for (const ColorAttachment& color : built.recipe.passes[0].colors) {
    EXPECT_NE(color.load, LoadOp::kLoad) << color.resource;
    if (color.resource == "kept") {
      EXPECT_EQ(color.load, LoadOp::kClear) << "uncovered pixels would look like misses";
    }
  }
}

// FragCoord.w, three floats of place, four of tint.
TEST(StrategyRepair, KeepsTheInputsInWordsOfFour) {
  const BuiltRecipe built = repaired(programOf(kPlain)).value();
  std::vector<ResourceFormat> kept;
  for (const Resource& resource : built.recipe.resources)
    if (resource.name.starts_with("kept")) kept.push_back(resource.format);
  EXPECT_EQ(kept, (std::vector<ResourceFormat>{ResourceFormat::kRgba32Uint, ResourceFormat::kRgba32Uint}));
  EXPECT_EQ(inputsOf(moduleNamed(built, "fragment_repair")), std::vector<std::string>{"built-in 15"}) << "FragCoord alone";
}

TEST(StrategyRepair, KeepsEveryTypeOfInputThatItAllows) {
  const Pair pair = {"layout(location = 1) flat in int i;\nlayout(location = 2) flat in uvec2 u;\nlayout(location = 3) in mat2x3 m;\n"
                     "layout(location = 5, component = 1) noperspective in vec2 n;\nlayout(location = 6) centroid in float c;\n",
                     "layout(location = 1) flat out int i;\nlayout(location = 2) flat out uvec2 u;\nlayout(location = 3) out mat2x3 m;\n"
                     "layout(location = 5, component = 1) noperspective out vec2 n;\nlayout(location = 6) centroid out float c;\n",
                     "i = 3; u = uvec2(4, 5); m = mat2x3(0.5); n = position.xy; c = position.z;",
                     "vec4(m[1] * float(i), c) + float(u.x + u.y) * n.xyxy + gl_FragCoord * (gl_FrontFacing ? 1.0 : 0.5)"};
  const ShaderProgram program = programOf(pair);
  const KeptInputs kept = keptInputs(program.fragment->module, false).value();
  EXPECT_EQ(keptWords(kept), 2u + 3 + 1 + 2 + 6 + 2 + 1 + 1);
  std::vector<std::string> types;
  for (const KeptInput& input : kept.inputs) types.push_back(input.layout + input.type);
  std::sort(types.begin(), types.end());
  EXPECT_EQ(types, (std::vector<std::string>{"layout(location = 0) in vec3", "layout(location = 1) flat in int", "layout(location = 2) flat in uvec2",
                                             "layout(location = 3) in mat2x3", "layout(location = 5, component = 1) noperspective in vec2",
                                             "layout(location = 6) centroid in float"}));
  const Result<BuiltRecipe> built = repaired(program);
  ASSERT_TRUE(built.ok()) << formatError(built.error());
  // Built-ins 15 FragCoord, 17 FrontFacing.
  EXPECT_EQ(inputsOf(moduleNamed(*built, "fragment_repair")), std::vector<std::string>{"built-in 15"});
  const std::vector<std::string> drawn = inputsOf(moduleNamed(*built, "fragment_hits"));
  for (const char* input : {"built-in 15", "built-in 17", "location 0", "location 1", "location 2", "location 3", "location 5", "location 6"})
    EXPECT_EQ(std::count(drawn.begin(), drawn.end(), input), 1) << input;
}

TEST(StrategyRepair, KeepsNothingThatTheShaderDoesNotRead) {
  Pair pair = kPlain;
  pair.work = "vec4(2.0)";
  EXPECT_EQ(keptWords(keptInputs(programOf(pair).fragment->module, false).value()), 1u + 3);
}

TEST(StrategyRepair, KeepsTheDepthWhereHistoriesHoldIt) {
  const ShaderProgram program = programOf(kPlain);
  EXPECT_FALSE(keptInputs(program.fragment->module, false)->keeps_depth);
  EXPECT_TRUE(keptInputs(program.fragment->module, true)->keeps_depth);
}

TEST(StrategyRepair, IsRefusedWhereNeighboursAreAsked) {
  Pair pair = kPlain;
  pair.work = "vec4(fwidth(place.x))";
  EXPECT_EQ(refusalOf(pair), "repair.derivatives");
}

TEST(StrategyRepair, IsRefusedWhereTheShaderDecidesWhatIsDrawn) {
  Pair pair = kPlain;
  pair.work = "tint); if (tint.x > 0.75) discard; color += (tint";
  EXPECT_EQ(refusalOf(pair), "repair.discards");
  pair.work = "tint); gl_FragDepth = (tint.x";
  EXPECT_EQ(refusalOf(pair), "repair.discards");
}

TEST(StrategyRepair, IsRefusedForInputsThatCannotBeTakenUpAgain) {
  EXPECT_EQ(refusalOf({"layout(location = 1) in vec4 tint[2];\n", "layout(location = 1) out vec4 tint[2];\n", "tint[0] = tint[1] = vec4(0.5);",
                       "tint[0] + tint[1]"}),
            "repair.input");
  Pair pair = kPlain;
  pair.work = "tint * float(gl_PrimitiveID)";
  EXPECT_EQ(refusalOf(pair), "repair.input");
  pair.work = "interpolateAtOffset(tint, vec2(0.25))";
  EXPECT_EQ(refusalOf(pair), "repair.input");
}

// Eight words need two targets more than the device has beside six outputs.
TEST(StrategyRepair, IsRefusedWhereItsTargetsAreTooMany) {
  Pair pair = kPlain;
  for (int output = 1; output <= 5; ++output) {
    pair.inputs += "layout(location = " + std::to_string(output) + ") out vec4 more" + std::to_string(output) + ";\n";
    pair.work += "); more" + std::to_string(output) + " = (tint * float(" + std::to_string(output) + ")";
  }
  EXPECT_EQ(refusalOf(pair), "state.targets");
}

// 32 inputs of four words: far more than there are targets for, and than the frames are written for.
TEST(StrategyRepair, IsRefusedBeforeAFrameIsMadeForInputsBeyondAllTargets) {
  Pair pair = kPlain;
  for (int input = 2; input < 30; ++input) {
    const std::string name = "more" + std::to_string(input), at = "layout(location = " + std::to_string(input) + ") ";
    pair.inputs += at + "in vec4 " + name + ";\n";
    pair.vertex_outputs += at + "out vec4 " + name + ";\n";
    pair.vertex_code += " " + name + " = vec4(position, 0.5);";
    pair.work += " + " + name;
  }
  EXPECT_EQ(refusalOf(pair), "state.targets");
}

TEST(LinkFrame, OlderModulesKnowStorageBuffersByAnExtension) {
  Module host = moduleOf("#version 450\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
  const Module frame = moduleOf("#version 450\nlayout(set = 0, binding = 0) buffer Tiles { uint flags[]; };\nvoid main() { flags[0] = 1u; }\n");
  const auto declares = [](const Module& linked) {
    return std::any_of(linked.extensions.begin(), linked.extensions.end(),
                       [](const Instruction& one) { return stringOf(one.operands[0]) == "SPV_KHR_storage_buffer_storage_class"; });
  };
  EXPECT_FALSE(declares(linkFrame(host, frame, {})));
  host.version = 0x00010000;
  EXPECT_TRUE(declares(linkFrame(host, frame, {})));
}

}  // namespace
}  // namespace reprise
