// What a fit is worth. A fit that went wrong is a result like any other: it says so here and throws nothing.
#pragma once

#include <string>

namespace reprise {

enum class FitVerdict {
  kGood,
  kFewPoints,       // no more points than parameters: the model passes through them and nothing vouches for it
  kPoor,            // converged, but the model leaves much of what was measured unexplained
  kUnidentifiable,  // the rows cannot tell some parameters apart; the explanation names them and what was assumed
  kNotConverged,    // the solver gave up: the parameters are where it stopped and must not be used
  kNoPoints,        // nothing usable to fit
};

// Spellings of files and reports: "good", "few_points", "poor", "unidentifiable", "not_converged", "no_points".
const char* nameOf(FitVerdict verdict);

// Whether predictions may be made from the fit at all: false for kNotConverged and kNoPoints.
bool isUsable(FitVerdict verdict);

// A parameter with its 95% interval. A bound of the interval that is not known is infinite; intervals are cut at the
// parameter's own bounds.
struct FittedParameter {
  std::string name;  // "alpha"
  double value = 0;
  double lo = 0, hi = 0;
  bool operator==(const FittedParameter&) const = default;
};

}  // namespace reprise
