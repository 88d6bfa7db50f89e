#include "cli/check/interpreted.h"

#include <fmt/format.h>

#include "cli/check/interpreter/interpret.h"

namespace reprise {
namespace {

constexpr std::uint64_t kMostSteps = 1u << 21;  // of the given module, at all points together: a part of a second

}  // namespace

Interpreted interpretPrepared(std::span<const std::uint32_t> given, std::span<const std::uint32_t> prepared) {
  CompareOptions options;
  options.most_steps_together = kMostSteps;
  CompareCounts counts;
  const auto compared = compareComputations(given, prepared, "", options, &counts);
  if (!compared.ok()) return {Computation::kUnknown, compared.error().message};
  if (const std::optional<ComputationDifference>& difference = *compared)
    return {Computation::kDifferent, fmt::format("at ({}, {}), seed {}: expected {}, found {}", difference->frag_x, difference->frag_y,
                                                 difference->seed, difference->expected, difference->found)};
  if (counts.returned + counts.discarded == 0) return {Computation::kUnknown, "no point was compared"};
  return {Computation::kSame, ""};
}

}  // namespace reprise
