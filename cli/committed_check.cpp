#include "cli/committed_check.h"

#include <fmt/format.h>

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

}  // namespace reprise
