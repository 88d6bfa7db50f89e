// Random fragment shaders that are hard on whoever rewrites control flow: what a fuzz run and its test feed to the rewriter.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace reprise {

struct RandomShaderOptions {
  int functions = 2;        // at most so many beside main
  int statements = 4;       // of a function's outermost block, about; nested blocks have fewer
  int depth = 4;            // of nested statements, at most
  int value_depth = 2;      // of nested expressions, at most
  int most_steps = 2500;    // statements that an invocation may execute, at most, by a cautious count
};

// A shader in GLSL 4.50 for Vulkan, the same for the same seed and options on every machine. It is valid, its loops end, its floats stay
// finite, no undefined value is read and no index leaves its array, whatever the inputs. It is made of loops of all forms, switches, breaks,
// continues, early returns, functions with inout and out parameters, private variables, arrays and structures with dynamic indices, and of
// integers and floats that are carried around the loops and copied among each other; all of them reach the colours.
std::string randomShader(std::uint64_t seed, const RandomShaderOptions& options = {});

}  // namespace reprise
