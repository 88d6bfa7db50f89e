#include "compiler/strategies/registry.h"

namespace reprise {

std::span<const Strategy> strategies() {
  static const Strategy kStrategies[] = {
      makeBranchStrategy(),   makeTwoPassStrategy(),          makeTwoPassStencilStrategy(), makeThreePassStrategy(),
      makeOriginalStrategy(), makeOriginalPrepassStrategy(), makeTailOnlyStrategy(),
  };
  return kStrategies;
}

const Strategy* findStrategy(const std::string& name) {
  for (const Strategy& strategy : strategies())
    if (strategy.name == name) return &strategy;
  return nullptr;
}

}  // namespace reprise
