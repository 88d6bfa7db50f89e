// What a loop leaves behind as a value of its own.
//
// A value that a loop computes and code after the loop uses is one that the loop has many of; what is used is the last. In
// loop-closed form (Rastello, Bouchez Tichadou, "SSA-based Compiler Design", section 16.2) a phi in the loop's merge block stands
// for that last one, so that it can be kept like any other value.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "compiler/ir/module.h"

namespace reprise {

struct LoopClosed {
  Module module;
  std::unordered_map<std::uint32_t, std::uint32_t> result_of;  // a loop's value -> the phi that stands for its last one
};

// Of functions whose loops times instructions are more no loop is closed, so that hostile input ends in time.
inline constexpr std::size_t kMostLoopsTimesInstructions = std::size_t{1} << 26;

// Only values of types that can be kept (payload_type.h). Those whose block does not dominate the merge block keep their
// uses as they are. Inner loops first, so a value that leaves several loops gets a phi after each.
LoopClosed closeLoops(const Module& module, std::uint32_t function);

}  // namespace reprise
