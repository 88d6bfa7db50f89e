// Versions of the libraries that read and write shaders, as they are linked.
#pragma once

#include <string>

namespace reprise {

std::string glslangVersion();     // "11.8.0"
std::string spirvToolsVersion();  // "v2023.1"

}  // namespace reprise
