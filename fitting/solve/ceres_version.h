// The version of the solver library.
#pragma once

#include <string>

namespace reprise {

std::string ceresVersion();  // "2.1.0"

}  // namespace reprise
