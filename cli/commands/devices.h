// `reprise devices`: what can be measured on.
#pragma once

#include <ostream>

#include "runtime/base/result.h"

namespace reprise {

// One line per Vulkan device: index, name, driver, version, and the clock that binds on it; or a JSON array of the same.
// Errors: device.none (kMachine).
Result<void> listDevicesCommand(bool json, std::ostream& out);

}  // namespace reprise
