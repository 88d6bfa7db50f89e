// The report of a finished run's directory, again from result.json, evidence.json and the pictures beside them (stage 11).
#pragma once

#include <string>

#include "runtime/base/result.h"

namespace reprise {

// Writes DIR/report.html. Errors: file.*, result.*, evidence.*. A run of a version that left no evidence.json is reported without it.
Result<void> reportAgain(const std::string& directory);

// "markdown": a table for a pull request; "csv": every point for a spreadsheet. Errors: as above; report.format (kUsage).
Result<std::string> reportText(const std::string& directory, const std::string& format);

}  // namespace reprise
