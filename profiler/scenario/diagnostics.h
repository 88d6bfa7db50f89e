// The mistakes found in a scenario: all of them, so that the user need not run once a mistake.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

// Nobody mends more at once, and finding near names for each of a million would take minutes.
inline constexpr std::size_t kMostDiagnostics = 100;

struct Diagnostics {
  std::vector<Error> errors;  // the first kMostDiagnostics

  bool full() const { return errors.size() >= kMostDiagnostics; }
  // Adds a kInput error; a code is "scenario." and `kind`.
  void add(const std::string& kind, const std::string& message, const Place& place);
};

// By line and column; what has no line comes last.
void sortByPlace(Diagnostics& diagnostics);

}  // namespace reprise
