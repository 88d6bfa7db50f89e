#include "tests/runtime/sample_package.h"

#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

constexpr std::uint32_t kSpirvMagic = 0x07230203;

Recipe originalRecipe() {
  Recipe recipe;
  recipe.strategy = "original";
  recipe.uses_reprise_set = false;
  Pass pass;
  pass.name = "original";
  pass.vertex_module = "vertex";
  pass.fragment_module = "fragment";
  pass.colors = {{0, "", LoadOp::kClear, BlendKind::kReplace, 0}};
  recipe.passes = {pass};
  return recipe;
}

Recipe cachedRecipe() {
  Recipe recipe = originalRecipe();
  recipe.strategy = "two_pass";
  recipe.uses_reprise_set = true;
  recipe.reprise_set = 2;
  recipe.pattern = PatternKind::kTiled;
  recipe.filter = Filter::kBilinear;
  recipe.period_frames = kNeverRefresh;
  recipe.constants.tolerance[0] = 0.1f;  // not exact in binary: text must bring back the same float
  recipe.resources = {{"cache", ResourceFormat::kRgba16Sfloat, 1, Lifetime::kHistory, {0, 0, 0, 1}}};
  recipe.passes[0].colors.push_back({-1, "cache", LoadOp::kClear, BlendKind::kReplace, 1});
  recipe.passes[0].reads = {{"cache", 2, Filter::kBilinear, false}};
  recipe.passes.push_back(recipe.passes[0]);
  recipe.passes[1].name = "misses";
  recipe.passes[1].reads.clear();
  recipe.passes[1].depth_clear = false;
  recipe.payload = {{"noise", "float", "marble.frag", 12, 3, 1, 0, kNoGuard, {0.25f, 0, 0, 0}, {0.5f, 0, 0, 0}, {"Scene.scale", "texture albedo"}}};
  recipe.previous_inputs = {{PreviousSource::kUniformBlock, "Scene", 0, 1, 64, 16},
                            {PreviousSource::kPushConstants, "Draw", 0, 0, 16, 16}};
  return recipe;
}

}  // namespace

Package twoPassPackage() {
  Package package;
  package.tool_version = "0.1.0";
  package.interface.outputs = {{"color", 0, ScalarKind::kFloat, 4}};
  package.interface.vertex_inputs = {{"position", 0, ScalarKind::kFloat, 3}};
  package.interface.push_constants = {{kStageVertex, 0, 16}};
  package.original = originalRecipe();
  package.variant = cachedRecipe();
  package.modules["vertex"] = {kSpirvMagic, 0x10300, 0, 1, 0, 7};
  package.modules["fragment"] = {kSpirvMagic, 0x10300, 0, 1, 0, 8};
  for (Recipe* recipe : {&package.original, &package.variant})
    for (const auto& [name, words] : package.modules) recipe->modules.push_back({name, name, contentHash(bytesOf(words))});
  return package;
}

}  // namespace reprise
