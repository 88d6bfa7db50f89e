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
  double module_timeout_s = 60;       // as time_limit.h has it
  std::function<bool()> interrupted;
};

// Verdicts in the order of `requests`; `done` is called as each comes in. A worker that ends without a verdict makes the module
// crashed or hung (prepare.*, variant.*), or untestable (source.*) where it had not got beyond compiling. Modules that lost the device,
// crashed or hung beside others are run again alone, at the end. Errors: kInterrupted, kMachine (no process).
Result<std::vector<ModuleVerdict>> runModules(const std::vector<CheckRequest>& requests, const RunModulesOptions& options,
                                              const std::function<void(const ModuleVerdict&)>& done);

// The worker's side: a request as JSON on standard input; stages and the verdict as lines on standard output. executable: this
// program, which is started again as the reference.
int runCheckWorker(const std::string& executable);

}  // namespace reprise
