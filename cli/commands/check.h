// `reprise check`: the differential test of the rewrites on the user's own shaders and device, without a scenario.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "cli/check/verdict.h"
#include "runtime/base/result.h"

namespace reprise {

struct CheckArguments {
  std::vector<std::string> shaders;  // files, and directories whose .frag, .hlsl, .spv and .spvasm files are taken, sorted
  CheckRequest request;              // path is set for each
  int jobs = 0;                      // 0: the number of cores
  double module_timeout_s = 60;
  bool json = false;
  bool quiet = false;
  std::string worker_path;
  std::function<bool()> interrupted;
};

// Prints a line for each module and a summary; or one JSON document, the lines then going to `progress` unless quiet. True if nothing failed, crashed or hung. Errors: file.missing
// (kInput), strategy.unknown (kUsage), device.none (kMachine), kInterrupted.
Result<bool> checkShaders(const CheckArguments& arguments, std::ostream& out, std::ostream& progress);

}  // namespace reprise
