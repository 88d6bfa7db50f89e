// Before anything of a variant is measured it is held to laws 1 and 3 on the scenario's own inputs: at its exact setting, and in a frozen
// scene whose pixels hit, it must show what the original shows. In every session eight frames and four frozen ones, at full resolution.
//
// What depends on candidate and strategy is held once for both: the variant is played with payloads kept in 32-bit floats, fetched
// with the nearest filter, so that nothing but the rewriting can show. Differences that may be rounding need a witness: both sides
// with NoContraction must agree. Verdicts are kept in the store.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/progress.h"
#include "cli/subject.h"
#include "cli/workspace.h"
#include "profiler/training/compare_with_original.h"

namespace reprise {

struct VariantToHold {
  Candidate candidate;
  VariantOptions options;             // of which the strategy is held, whatever the filter and the encoding
  std::vector<std::string> packages;  // further packages of it on disk, such as the one that ships: at their exact setting, as they are
};

struct LawVerdict {
  std::optional<FailureRow> conviction;  // law.exact_setting, law.frozen_world; or why it could not be played. With the place: session, frame, pixel, values, pass
  std::uint64_t frozen_hits = 0;         // 0: no hit was compared, or none could be counted
  bool refused = false;                  // there is no such variant, so nothing was compared
};

// Whether the package differs from the original, rather than could not be played.
bool isLawBroken(const FailureRow& conviction);

// Training holds a candidate in the sessions that it is about to be measured in; whatever is accepted was held in all of them.
enum class HeldSessions { kAll, kTraining };

// One verdict by variant. Errors: those of compareWithOriginal and the store.
Result<std::vector<LawVerdict>> holdLaws(const Subject& subject, const Workspace& workspace, const Measuring& measuring,
                                         const std::vector<VariantToHold>& variants, Progress& progress,
                                         HeldSessions sessions = HeldSessions::kAll);

}  // namespace reprise
