// Outputs of a build step: written only where they differ, so that what depends on them is not built again.
#pragma once

#include <filesystem>
#include <string_view>

#include "runtime/base/result.h"
#include "runtime/package/package.h"

namespace reprise {

// Whether the file was written. Errors: those of writeFile.
Result<bool> writeIfChanged(const std::filesystem::path& file, std::string_view bytes);

// A package with its readable GLSL, in place of the one that was there: modules of that one which the new one does not have are
// removed, other files are left alone. Made aside first: a failure leaves the old package as it was. Whether anything was written.
Result<bool> writePackageIfChanged(const Package& package, const std::filesystem::path& directory);

}  // namespace reprise
