#include "cli/check/reference/play_original.h"

#include <algorithm>

namespace reprise {

Package originalPackage(const PlayedModule& module) {
  Package package;
  package.interface = module.interface;
  package.modules = {{"vertex", module.vertex_words}, {"fragment", module.fragment_words}};
  Recipe& recipe = package.original;
  recipe.strategy = "original";
  recipe.period_frames = 1;
  recipe.modules = {{"vertex", "vertex", ""}, {"fragment", "fragment", ""}};
  for (const Descriptor& descriptor : module.interface.descriptors) recipe.reprise_set = std::max(recipe.reprise_set, descriptor.set + 1);
  recipe.uses_reprise_set = false;
  Pass pass;
  pass.name = "original";
  pass.vertex_module = "vertex";
  pass.fragment_module = "fragment";
  int most = 1;
  for (std::size_t output = 0; output < module.interface.outputs.size(); ++output) {
    const int location = static_cast<int>(module.interface.outputs[output].location);
    pass.colors.push_back({static_cast<int>(output), "", LoadOp::kClear, BlendKind::kReplace, location});
    most = std::max(most, location + 1);
  }
  recipe.requirements.color_attachments = most;
  recipe.passes.push_back(std::move(pass));
  package.variant = recipe;
  return package;
}

Result<std::vector<HarnessFrame>> playOriginal(Harness& harness, const PlayedModule& module, int frames) {
  REPRISE_ASSIGN(Player player, harness.createPlayer(originalPackage(module), true));
  return playFrames(harness, player, frames);
}

Result<std::vector<HarnessFrame>> playFrames(Harness& harness, Player& player, int frames) {
  std::vector<HarnessFrame> played;
  for (int frame = 0; frame < frames; ++frame) {
    REPRISE_ASSIGN(HarnessFrame one, harness.play(player, {frame, 1}));
    played.push_back(std::move(one));
  }
  return played;
}

}  // namespace reprise
