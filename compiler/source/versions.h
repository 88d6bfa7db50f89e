// Versions of the libraries that read and write shaders, as they are linked.
#pragma once

#include <string>

namespace reprise {

std::string glslangVersion();     // "11.8.0"
std::string spirvToolsVersion();  // "v2023.1"
std::string spirvCrossVersion();  // "0.54.0": of its C API, the only number that it has

}  // namespace reprise
