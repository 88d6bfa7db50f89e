// What ships: a directory with manifest.json, one NAME.spv per module, and readable NAME.glsl beside them.
//
// manifest.json holds the interface, the recipe of the chosen variant and the recipe of the original (played where
// requirements are missing). readPackage(writePackageFiles(p)) == p in all that it holds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/package/interface.h"
#include "runtime/package/recipe.h"

namespace reprise {

inline constexpr std::size_t kMostModules = 64;  // of a recipe: reading a package reads a file for each

struct Package {
  std::string tool_version;
  ShaderInterface interface;
  Recipe original;   // strategy "original"
  Recipe variant;    // may itself be an original, where that was the answer
  std::map<std::string, std::vector<std::uint32_t>> modules;  // SPIR-V by ModuleEntry::name, of both recipes
  std::map<std::string, std::string> readable;                // GLSL by module name; for people, not read back
};

// JSON texts of the parts, for manifests, job files and reports. Round trips are exact.
std::string recipeToJson(const Recipe& recipe);
Result<Recipe> recipeFromJson(const std::string& text);
std::string interfaceToJson(const ShaderInterface& interface);
Result<ShaderInterface> interfaceFromJson(const std::string& text);

// Writes all files of the package into `directory`, the manifest last, each by rename. Errors: file.unwritable.
Result<void> writePackageFiles(const Package& package, const std::filesystem::path& directory);

// Errors (kInput, each naming the file): package.missing, package.manifest (not JSON, a key missing or of a wrong type),
// package.version (another format), package.tampered (a module's hash differs), package.inconsistent (a pass that names a
// module or resource that is not there, a binding out of range, counts beyond kMaxPasses...).
Result<Package> readPackage(const std::filesystem::path& directory);

// Checks the cross references of a package in memory; the last step of readPackage.
Result<void> checkPackage(const Package& package);

}  // namespace reprise
