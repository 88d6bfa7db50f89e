// At which refresh periods training measures errors.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "profiler/scenario/scenario.h"

namespace reprise {

// Of the scenario's periods those longer than 1 whose settled frames lie within every training session, in the scenario's order. Longer ones are
// left to the models and to validation.
std::vector<std::uint32_t> studiedPeriods(const Scenario& scenario);

// The same of the validation sessions: others could never be accepted.
std::vector<std::uint32_t> selectablePeriods(const Scenario& scenario);

// Of each session that is too short for a period: its frames, those that the period needs, and what comes of it.
std::vector<std::string> shortSessionWarnings(const Scenario& scenario);

// Of them those at which alternatives to the best variant so far are measured: the shortest, the best one's own (no longer than the longest) and
// the longest; "never" only where the best is never refreshed.
std::vector<std::uint32_t> refinedPeriods(const std::vector<std::uint32_t>& studied, std::uint32_t best);

}  // namespace reprise
