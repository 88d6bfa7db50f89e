// Lists of SPIRV-Tools' passes over random modules: to make the forms in which modules come from other tools, and to show what a
// fault of such a pass looks like to the oracle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

enum class PassList {
  kOptimize,     // spirv-opt -O
  kWithoutCalls,  // the like of it without inlining
  kPromotion,    // early returns merged, calls inlined, locals promoted by ssa-rewrite: what the project once prepared modules with
};

// Error: spirv.optimize (kInput) where a pass gives up.
Result<std::vector<std::uint32_t>> runPassList(std::span<const std::uint32_t> words, PassList list);

}  // namespace reprise
