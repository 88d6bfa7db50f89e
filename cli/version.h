// The version of the tool, as CMake's project() states it, and what it stands on.
#pragma once

#include <string>

namespace reprise {

inline constexpr const char* kToolVersion = REPRISE_VERSION;

// A line for the tool and for each library, then the formats of its files.
std::string versionText();

}  // namespace reprise
