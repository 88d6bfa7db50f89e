// Limits on what a SPIR-V module may have many of, so that time and memory stay bounded whatever a file says: 1 MiB is
// accepted or refused within 10 s and 1 GiB. They lie far above what real shaders have.
//
// Told by one walk over the words before anything else looks at them: the validator itself takes minutes for some files of a
// few kilobytes.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/result.h"

namespace reprise {

// SPIRV-Tools' passes keep tables by id and fail where fresh ids run out at 4 million.
inline constexpr std::uint32_t kMaxIds = 1u << 20;
// The validator walks the call graph anew for each function and entry point.
inline constexpr std::size_t kMostFunctions = 2048;
inline constexpr std::size_t kMostEntryPoints = 256;
// Of an entry point with all calls inlined, as SPIRV-Cross walks it and as it is analysed; some analyses are quadratic.
inline constexpr std::size_t kMostInlinedInstructions = 40000;
inline constexpr int kMostCallDepth = 256;  // calls are followed by recursion, by SPIRV-Tools and SPIRV-Cross, too
// For each loop and selection the validator visits the blocks in it and, for each of these, the constructs around it.
inline constexpr std::size_t kMostBlocks = 8192;
inline constexpr std::size_t kMostLoops = 512;
inline constexpr std::size_t kMostSelections = 1024;
inline constexpr std::size_t kMostNesting = 64;  // of loops and selections in one function
// A type's parts are itself and those of its members. The validator visits them for each use, and those of local variables,
// where elements of arrays count, too, become variables when locals are taken apart. Of one type, and over all results.
inline constexpr std::uint64_t kMostPartsOfType = 8192;
inline constexpr std::uint64_t kMostTypeParts = 1u << 21;
// Decorations of groups times what they are given to: the validator copies them.
inline constexpr std::uint64_t kMostGroupDecorations = 1u << 20;

// Error: spirv.limit (kInput), with what was found and what is allowed. Says nothing of what is no SPIR-V.
Result<void> checkModuleLimits(std::span<const std::uint32_t> words);

}  // namespace reprise
