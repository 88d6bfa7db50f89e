// Checks many modules, each in a process of its own, so that the run goes on past a crash or a hang.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/check/verdict.h"
#include "runtime/base/result.h"

namespace reprise {

struct RunModulesOptions {
  std::string worker_path;            // the executable, called with "check-worker"
  int jobs = 1;                       // at once
  double module_timeout_s = 60;
  std::function<bool()> interrupted;
};

// Verdicts in the order of `requests`; `done` is called as each comes in. A worker that ends before the original was played makes
// the module untestable (original.crashed, original.hung), after it crashed or hung. Modules that
// lost the device, crashed or hung beside others are run again alone, at the end. Errors: kInterrupted, kMachine (no process).
Result<std::vector<ModuleVerdict>> runModules(const std::vector<CheckRequest>& requests, const RunModulesOptions& options,
                                              const std::function<void(const ModuleVerdict&)>& done);

// The worker's side: a request as JSON on standard input; "original runs" and the verdict as lines on standard output.
int runCheckWorker();

}  // namespace reprise
