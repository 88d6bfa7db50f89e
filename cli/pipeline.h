// A run from a scenario to a package, stage by stage. The table of contents of the project.
#pragma once

#include <functional>
#include <string>

#include "cli/committed_check.h"
#include "cli/demand.h"
#include "cli/progress.h"
#include "cli/report/result.h"
#include "runtime/base/result.h"

namespace reprise {

struct OptimizeArguments {
  std::string scenario;         // path of the TOML file
  Demand demand;                // what binds
  double least_gain = kLeastGain;
  double budget_s = 0;          // from when the device is held (budget.h); 0: none
  std::string output = "out";
  std::string device;
  std::string worker_path;      // this executable
  std::string command;          // as typed, for the report
  std::function<bool()> interrupted;
};

// Writes DIR/package, DIR/scenario, DIR/result.json and DIR/report.html; returns what result.json holds. Errors: of the stages.
Result<RunResult> optimize(const OptimizeArguments& arguments, Progress& progress);

// Measures DIR's choice again on this device; the result is that of the run with choice, original and validation renewed. Does not
// write. Errors: result.*, package.*, and of the stages.
Result<RunResult> validateAgain(const std::string& directory, const OptimizeArguments& arguments, Progress& progress);

// Measures a committed choice of the sources as they are now, in the workspace `arguments.output`, and holds it against its threshold
// and its recorded cost (committed_check.h); what fails by its time is timed again. Errors: choice.*, validate.original, and of the stages.
struct CommittedArguments {
  std::string choice, scenario;
  double cost_tolerance = 0.2;
};
Result<CommittedCheck> validateCommitted(const CommittedArguments& committed, const OptimizeArguments& arguments, Progress& progress);

}  // namespace reprise
