#include "cli/studied_periods.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/trained.h"

namespace reprise {
namespace {

int framesOf(const Scenario& scenario, const SessionSpec& session) { return session.frames > 0 ? session.frames : scenario.frames; }

int shortestSession(const Scenario& scenario, SessionRole role) {
  int shortest = 1 << 30;
  for (const SessionSpec& session : scenario.sessions)
    if (session.role == role) shortest = std::min(shortest, framesOf(scenario, session));
  return shortest;
}

// Longer than 1, and settled within all sessions of the role.
std::vector<std::uint32_t> periodsWithin(const Scenario& scenario, SessionRole role) {
  const int frames = shortestSession(scenario, role);
  std::vector<std::uint32_t> periods;
  for (const std::uint32_t period : scenario.periods)
    if (period != 1 && firstSettledFrame(period) < frames) periods.push_back(period);
  return periods;
}

}  // namespace

std::vector<std::uint32_t> studiedPeriods(const Scenario& scenario) { return periodsWithin(scenario, SessionRole::kTraining); }

std::vector<std::uint32_t> selectablePeriods(const Scenario& scenario) { return periodsWithin(scenario, SessionRole::kValidation); }

std::vector<std::string> shortSessionWarnings(const Scenario& scenario) {
  std::vector<std::string> warnings;
  for (const SessionSpec& session : scenario.sessions) {
    const int frames = framesOf(scenario, session);
    std::uint32_t shortest = 0;
    std::string left_out;
    for (const std::uint32_t period : scenario.periods) {
      if (period == 1 || firstSettledFrame(period) < frames) continue;
      if (shortest == 0 || period < shortest) shortest = period;
      left_out += (left_out.empty() ? "" : ", ") + std::to_string(period);
    }
    if (shortest == 0) continue;
    const char* what = session.role == SessionRole::kTraining ? "so the errors of these are predicted, not measured" : "so these cannot be validated and are not tried";
    warnings.push_back(fmt::format("session '{}' has {} frames; period {} needs more than {}, {}: {}", session.name, frames, shortest, 2 * shortest, what, left_out));
  }
  return warnings;
}

std::vector<std::uint32_t> refinedPeriods(const std::vector<std::uint32_t>& studied, std::uint32_t best) {
  std::vector<std::uint32_t> finite;
  for (const std::uint32_t period : studied)
    if (period != kNeverRefresh) finite.push_back(period);
  std::vector<std::uint32_t> periods;
  if (!finite.empty()) {
    const auto [shortest, longest] = std::minmax_element(finite.begin(), finite.end());
    const std::uint32_t middle = best == kNeverRefresh ? *longest : std::min(best, *longest);
    for (const std::uint32_t period : {*shortest, middle, *longest})
      if (std::find(periods.begin(), periods.end(), period) == periods.end()) periods.push_back(period);
  }
  if (best == kNeverRefresh) periods.push_back(kNeverRefresh);
  return periods;
}

}  // namespace reprise
