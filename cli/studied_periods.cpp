#include "cli/studied_periods.h"

#include <algorithm>

#include "cli/trained.h"

namespace reprise {
namespace {

int shortestTrainingSession(const Scenario& scenario) {
  int shortest = 1 << 30;
  for (const SessionSpec& session : scenario.sessions)
    if (session.role == SessionRole::kTraining) shortest = std::min(shortest, session.frames > 0 ? session.frames : scenario.frames);
  return shortest;
}

}  // namespace

std::vector<std::uint32_t> studiedPeriods(const Scenario& scenario) {
  const int frames = shortestTrainingSession(scenario);
  std::vector<std::uint32_t> periods;
  for (const std::uint32_t period : scenario.periods)
    if (period != 1 && firstSettledFrame(period) < frames) periods.push_back(period);
  return periods;
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
