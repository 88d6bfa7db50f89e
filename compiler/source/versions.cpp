#include "compiler/source/versions.h"

#include <glslang/Public/ShaderLang.h>
#include <spirv-tools/libspirv.h>
#include <spirv_cross/spirv_cross_c.h>

namespace reprise {

std::string glslangVersion() {
  const glslang::Version version = glslang::GetVersion();
  return std::to_string(version.major) + "." + std::to_string(version.minor) + "." + std::to_string(version.patch);
}

std::string spirvToolsVersion() { return spvSoftwareVersionString(); }

std::string spirvCrossVersion() {
  return std::to_string(SPVC_C_API_VERSION_MAJOR) + "." + std::to_string(SPVC_C_API_VERSION_MINOR) + "." + std::to_string(SPVC_C_API_VERSION_PATCH);
}

}  // namespace reprise
