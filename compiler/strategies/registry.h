// The makers of the strategies, one in each .cpp of this folder.
#pragma once

#include "compiler/strategies/strategy.h"

namespace reprise {

Strategy makeBranchStrategy();
Strategy makeTwoPassStrategy();
Strategy makeTwoPassObjectsStrategy();
Strategy makeTwoPassStencilStrategy();
Strategy makeThreePassStrategy();
Strategy makeRepairStrategy();
Strategy makeOriginalStrategy();
Strategy makeOriginalPrepassStrategy();
Strategy makeTailOnlyStrategy();

}  // namespace reprise
