// Packages against the original on every session of a scenario, before anything of them is measured (laws 1 and 3): eight frames at the
// exact setting, then four of one moment held still.
//
// Session by session a first worker plays the original and nothing else, and leaves its colours in files; further ones play the packages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "profiler/training/measure.h"

namespace reprise {

struct LawRequest {
  std::string package_dir;
  std::uint32_t period_frames = 1;  // 1: at the exact setting alone
  double tolerance = 0;             // JobEntry::tolerance
};

// Of all sessions; of each kind the first that was found.
struct LawFinding {
  LawOutcome outcome;                // frozen_hits: over all sessions
  std::string session;               // of outcome.difference, else of outcome.rounding
  std::optional<FailureRow> failure; // it crashed, hung or cannot be played here
};

// One finding by request. `scratch`: a directory for the files, made and removed. Errors: original.unplayable (kInput): the original itself
// ends its process or hangs; kInterrupted, kMachine.
Result<std::vector<LawFinding>> compareWithOriginal(const Measuring& measuring, const std::vector<std::string>& sessions,
                                                    const std::vector<LawRequest>& requests, const std::string& scratch);

}  // namespace reprise
