// Errors as the command line tells them.
#pragma once

#include <iosfwd>

#include "runtime/base/result.h"

namespace reprise {

inline constexpr int kInputStatus = 1, kUsageStatus = 2, kMachineStatus = 3, kUndecidedStatus = 4, kInterruptedStatus = 130;

// Each error of them a line: as formatError has it, or a JSON object {code, message, file, line, column}. Returns the exit status, that of the first.
int reportError(const Error& error, bool as_json, std::ostream& out);

}  // namespace reprise
