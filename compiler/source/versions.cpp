#include "compiler/source/versions.h"

#include <glslang/Public/ShaderLang.h>
#include <spirv-tools/libspirv.h>

namespace reprise {

std::string glslangVersion() {
  const glslang::Version version = glslang::GetVersion();
  return std::to_string(version.major) + "." + std::to_string(version.minor) + "." + std::to_string(version.patch);
}

std::string spirvToolsVersion() { return spvSoftwareVersionString(); }

}  // namespace reprise
