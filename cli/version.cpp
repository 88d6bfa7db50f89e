#include "cli/version.h"

#include <fmt/format.h>
#include <vulkan/vulkan_core.h>

#include "cli/choice.h"
#include "compiler/source/versions.h"
#include "fitting/solve/ceres_version.h"
#include "profiler/measurements/sqlite_version.h"
#include "runtime/package/recipe.h"

namespace reprise {

std::string versionText() {
  const auto vulkan = VK_HEADER_VERSION_COMPLETE;
  return fmt::format("reprise {}\nglslang {}\nSPIRV-Tools {}\nSPIRV-Cross C API {}\nCeres {}\nSQLite {}\nVulkan headers {}.{}.{}\npackage format {}, choice format {}",
                     kToolVersion, glslangVersion(), spirvToolsVersion(), spirvCrossVersion(), ceresVersion(), sqliteVersion(), VK_API_VERSION_MAJOR(vulkan),
                     VK_API_VERSION_MINOR(vulkan), VK_API_VERSION_PATCH(vulkan), kRecipeFormatVersion, kChoiceFormatVersion);
}

}  // namespace reprise
