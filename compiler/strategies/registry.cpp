#include "compiler/strategies/registry.h"

#include <algorithm>

namespace reprise {

std::span<const Strategy> strategies() {
  static const Strategy kStrategies[] = {
      makeBranchStrategy(),   makeTwoPassStrategy(), makeTwoPassObjectsStrategy(),  makeTwoPassStencilStrategy(), makeThreePassStrategy(),
      makeRepairStrategy(),   makeOriginalStrategy(), makeOriginalPrepassStrategy(), makeTailOnlyStrategy(),
  };
  return kStrategies;
}

const Strategy* findStrategy(const std::string& name) {
  for (const Strategy& strategy : strategies())
    if (strategy.name == name) return &strategy;
  return nullptr;
}

bool repairs(const Strategy& strategy) {
  return std::any_of(strategy.passes.begin(), strategy.passes.end(), [](const PassPlan& pass) { return pass.kind == PassKind::kTiles; });
}

bool flagsDraws(const Strategy& strategy) {
  return std::any_of(strategy.passes.begin(), strategy.passes.end(), [](const PassPlan& pass) { return pass.flags_draws; });
}

}  // namespace reprise
