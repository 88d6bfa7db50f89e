// The last step of the compiler: a package on disk, with GLSL beside the SPIR-V for people to read (stage 6).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "runtime/base/result.h"
#include "runtime/package/package.h"

namespace reprise {

// The module as Vulkan GLSL 4.50 through SPIRV-Cross, with the names that it carries. For reading and
// comparing: compiling it again gives the same picture up to rounding, not the same module. Error:
// emit.unreadable (kInput) where SPIRV-Cross cannot express the module.
Result<std::string> readableGlsl(std::span<const std::uint32_t> words);

// Fills `readable` from `modules` and writes all files (writePackageFiles). A module that GLSL cannot express
// gets a text that says why instead: it does not keep a package from shipping. Errors: as writePackageFiles.
Result<void> writePackage(const Package& package, const std::filesystem::path& directory);

}  // namespace reprise
