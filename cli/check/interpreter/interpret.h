// A reference interpreter of fragment modules: what one fragment computes, held against what another module computes.
//
// It shares no code with compiler/ir and uses no parser of SPIRV-Tools, so that a fault of theirs is none of its own. Integers, booleans,
// pointers and branches are concrete. A float is a value, computed on the host, and a hash of the operation and its operands, component by
// component. Equal hashes are equal computations, whatever a device rounds; values are equal where hashes are. Copies, loads and stores,
// phis, calls, composites, shuffles and selects leave no trace in a hash. Constants hash by their bits, and so do integers that a float
// holds exactly; an integer that was made from floats carries their hash. What textures, derivatives and atomics give is made up from the hash
// of the operation and its operands. RelaxedPrecision and NoContraction are no part of a hash.
//
// Seeds choose the range of made-up floats in turn: [0, 1), [-1, 1), [0, 8), [0, 2). Made-up integers are 0 to 3; over four seeds from
// a multiple of four on each is every one of them, and over sixteen two that lie beside each other have all pairs. Indices out of range are
// clamped, as robust access does it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

// What one fragment reads. Varyings, images and blocks that are not given are made up from the seed: varyings by location and
// component as smooth functions of frag_x and frag_y, blocks and push constants by address. Nothing depends on ids or names.
struct InterpreterInputs {
  std::uint32_t seed = 1;
  float frag_x = 0.5f, frag_y = 0.5f;  // FragCoord.xy, in pixels
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::byte>> blocks;  // by set and binding
  std::vector<std::byte> push_constants;
  std::uint32_t undefined_fill = 0;  // bits that undefined values have
  std::uint64_t most_steps = 1u << 22;
};

// One 32-bit (or smaller) component of an output; those of 64 bits give their low and their high word. Built-in outputs (FragDepth, SampleMask)
// have locations from kBuiltInLocation + BuiltIn, those of Index 1 from kSecondIndexLocation.
inline constexpr std::uint32_t kBuiltInLocation = 0x10000, kSecondIndexLocation = 0x8000;
struct OutputWord {
  std::uint32_t location = 0, component = 0;
  bool is_float = false;
  std::uint32_t bits = 0;
  std::uint64_t hash = 0;  // of the computation
  bool undefined = false;  // never written, or made from an undefined value
};

struct Interpretation {
  enum class Ending { kReturned, kDiscarded, kEndless };
  Ending ending = Ending::kReturned;
  std::vector<OutputWord> outputs;  // by location and component; empty but for kReturned
  std::uint64_t side_effects = 0;   // hash of the stores to buffers and images and of the atomics, in order; 0: there were none
  bool reads_undefined = false;     // an undefined value reached an output, or undefined_behaviour
  // A branch, an address or a write to a buffer or image took an undefined value, an index left its array, or OpUnreachable was
  // reached: another module may well do something else.
  bool undefined_behaviour = false;
  std::uint64_t steps = 0;  // instructions, those of large composites counted more than once
};

// Interprets the fragment entry point `entry_point`, the only one where it is empty. Errors:
//   interpreter.invalid      the words are no valid module, or have no such entry point (kInput)
//   interpreter.unsupported  an instruction that it does not know, by name, or more memory than it gives (kRefused)
Result<Interpretation> interpretFragment(std::span<const std::uint32_t> words, const std::string& entry_point,
                                         const InterpreterInputs& inputs);

struct ComputationDifference {
  float frag_x = 0, frag_y = 0;
  std::uint32_t seed = 0;
  std::string expected, found;  // one line: which output, value and hash, or which ending
};

struct CompareOptions {
  std::uint32_t first_seed = 0;                   // a multiple of four, for the sake of made-up integers
  int seeds = 4;
  int points = 16;                                // per seed, on a grid over 64x64 pixels
  int more_seeds = 12;                            // after those, while blocks of the given module were not reached
  std::uint64_t most_steps = 1u << 20;            // of the given module, at one point
  std::uint64_t most_steps_together = 1u << 24;   // of the given module; after those no further point is begun
};

// How much a comparison shows: points that were compared, and those at which the given module says nothing.
struct CompareCounts {
  int blocks = 0, unreached = 0;    // of the given module's functions that were called; nothing is known of those unreached
  int returned = 0, discarded = 0;  // compared, by how the given module ended
  int endless = 0, undefined = 0;   // the given module did not end; modules differ, but the given one's behaviour is undefined
};

// nullopt: at all sampled points both compute the same by hash, and end the same way. Outputs that are undefined in the given module may be anything.
// Errors: those of interpretFragment, for either module.
Result<std::optional<ComputationDifference>> compareComputations(std::span<const std::uint32_t> given, std::span<const std::uint32_t> prepared,
                                                                 const std::string& entry_point, const CompareOptions& options,
                                                                 CompareCounts* counts = nullptr);

}  // namespace reprise
