// A valid module through every stage that rewrites it: the body of the rewriter's fuzz target and of its regression tests.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/result.h"

namespace reprise {

struct Rewriting {
  std::size_t candidates = 0;  // the best ones that are tried
  std::uint32_t choices = 0;   // bits that choose pattern, encoding, filter and the like
};

// The module's variants in all selectable strategies, each held against its meaning: every module valid, every refusal one
// with a code, every package consistent. A fragment module meets a harness vertex shader, a vertex module a plain fragment shader.
// Errors: those of the stages; a variant that breaks a promise ends the program.
Result<void> rewriteAll(std::span<const std::uint32_t> words, const Rewriting& rewriting);

}  // namespace reprise
