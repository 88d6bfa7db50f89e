// A module checked in the test's own process, its reference in one of the program.
#pragma once

#include <string>

#include "cli/check/check_module.h"

namespace reprise {

inline ModuleVerdict checkInPlace(const CheckRequest& request, const std::string& executable) {
  CheckHooks hooks;
  hooks.enters = [](CheckStage) {};
  hooks.start_reference = [&](const ReferenceModule& module) { return startReferenceProcess(executable, module, request.timeout_s); };
  return checkModule(request, hooks);
}

}  // namespace reprise
