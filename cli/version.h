// The version of the tool, as CMake's project() states it.
#pragma once

namespace reprise {

inline constexpr const char* kToolVersion = REPRISE_VERSION;

}  // namespace reprise
