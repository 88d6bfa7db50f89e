#include "fitting/models/fit_verdict.h"

#include "runtime/base/check.h"

namespace reprise {

const char* nameOf(FitVerdict verdict) {
  switch (verdict) {
    case FitVerdict::kGood: return "good";
    case FitVerdict::kFewPoints: return "few_points";
    case FitVerdict::kPoor: return "poor";
    case FitVerdict::kUnidentifiable: return "unidentifiable";
    case FitVerdict::kNotConverged: return "not_converged";
    case FitVerdict::kNoPoints: return "no_points";
  }
  REPRISE_CHECK(false, static_cast<int>(verdict));
  return "";
}

bool isUsable(FitVerdict verdict) {
  return verdict != FitVerdict::kNotConverged && verdict != FitVerdict::kNoPoints;
}

}  // namespace reprise
