#include "cli/committed_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cli/report/text.h"

namespace reprise {

Result<CommittedCheck> checkCommitted(const Choice& choice, const CommittedMeasures& measured, double cost_tolerance) {
  if (!measured.judgement.accepted) return Error{ErrorKind::kInput, measured.judgement.code, measured.judgement.reason, {}};
  const double recorded = choice.measured.speedup.value_or(0);
  const double most_cost = recorded > 0 ? (1 + cost_tolerance) / recorded : 0;
  if (recorded > 0 && !(1 / measured.speedup <= most_cost))
    return Error{ErrorKind::kInput, "validate.cost",
                 fmt::format("the cost is {} of the original's, recorded is {}, which is worse by more than the tolerance of {}: {} times as fast "
                             "as the original instead of {}",
                             formatNumber(1 / measured.speedup), formatNumber(1 / recorded), formatGiven(cost_tolerance),
                             formatNumber(measured.speedup), formatNumber(recorded)), {}};
  CommittedCheck check;
  check.sentence = fmt::format("error {} {} (at most {}; recorded {}), {} times as fast as the original (recorded {})", formatNumber(measured.error),
                               choice.limits.unit(), formatGiven(choice.limits.limit()), choice.measured.error ? formatNumber(*choice.measured.error) : "n/a",
                               formatNumber(measured.speedup), recorded > 0 ? formatNumber(recorded) : "n/a");
  if (measured.device != choice.device.name)
    check.note = "recorded on " + choice.device.name + ", measured on " + measured.device;
  return check;
}

bool failedByTime(const Error& error) {
  constexpr const char* kCodes[] = {"judge.not_faster", "judge.straddles", "judge.wall_not_faster", "judge.wall_straddles", "validate.cost"};
  return std::find(std::begin(kCodes), std::end(kCodes), error.code) != std::end(kCodes);
}

Result<CommittedCheck> checkCommittedAgain(const Choice& choice, const MeasureCommitted& measure, double cost_tolerance) {
  for (int timing = 1;; ++timing) {
    REPRISE_ASSIGN(const CommittedMeasures measured, measure(timing));
    Result<CommittedCheck> check = checkCommitted(choice, measured, cost_tolerance);
    const std::string how_often = timing == 1 ? "timed once" : fmt::format("timed {} times", timing);
    if (check.ok()) {
      check->sentence += "; " + how_often;
      return check;
    }
    Error failure = check.error();
    if (!failedByTime(failure)) return failure;
    if (timing < kMostTimings) continue;
    failure.message += "; " + how_often + ", none of which holds";
    return failure;
  }
}

}  // namespace reprise
