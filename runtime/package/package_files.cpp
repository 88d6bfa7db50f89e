// The package on disk: manifest.json with a hash of its own body, modules beside it.
#include <cstring>
#include <functional>

#include "runtime/base/file.h"
#include "runtime/base/hash.h"
#include "runtime/package/embedded.h"
#include "runtime/package/json.h"
#include "runtime/package/json_values.h"
#include "runtime/package/package.h"

namespace reprise {
namespace {

using nlohmann::json;

constexpr const char* kManifest = "manifest.json";
constexpr std::uint32_t kSpirvMagic = 0x07230203;
constexpr std::size_t kSpirvHeaderWords = 5;

// The bytes of a file of the package, by its name.
using FileSource = std::function<Result<std::string>(const std::string& name)>;

Result<std::vector<std::uint32_t>> wordsIn(const std::string& bytes, const std::filesystem::path& file) {
  if (bytes.size() % sizeof(std::uint32_t) != 0)
    return Error{ErrorKind::kInput, "spirv.size",
                 "a SPIR-V file has a whole number of 4-byte words, but this one has " + std::to_string(bytes.size()) +
                     " bytes; it may be cut short",
                 {file.string(), 0, 0}};
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  if (!words.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

Error manifestError(const std::filesystem::path& file, const std::string& code, const std::string& message) {
  return {ErrorKind::kInput, code, message, {file.string(), 0, 0}};
}

Result<void> readModules(const Recipe& recipe, const std::filesystem::path& directory, const FileSource& source, Package& package) {
  if (recipe.modules.size() > kMostModules)
    return manifestError(directory / kManifest, "package.inconsistent",
                         "a recipe names " + std::to_string(recipe.modules.size()) + " modules, expected at most " + std::to_string(kMostModules));
  for (const ModuleEntry& entry : recipe.modules) {
    if (entry.name.empty() || entry.name.find_first_of("/\\") != std::string::npos || entry.name.front() == '.')
      return manifestError(directory / kManifest, "package.inconsistent", "'" + entry.name + "' is no module name");
    const std::filesystem::path file = directory / (entry.name + ".spv");
    // Both recipes may name the module, each with a hash of its own.
    REPRISE_ASSIGN(const std::string bytes, source(entry.name + ".spv"));
    REPRISE_ASSIGN(std::vector<std::uint32_t> words, wordsIn(bytes, file));
    if (contentHash(bytesOf(words)) != entry.hash)
      return manifestError(file, "package.tampered",
                           "the module is not the one that the manifest names; run the optimizer again to make a sound package");
    if (words.size() < kSpirvHeaderWords || words.front() != kSpirvMagic)
      return manifestError(file, "package.inconsistent", "the file is no SPIR-V module");
    package.modules[entry.name] = std::move(words);
  }
  return {};
}

std::string manifestText(const Package& package) {
  json body = {{"format_version", kRecipeFormatVersion}, {"tool_version", package.tool_version},
               {"interface", interfaceJson(package.interface)}, {"original", recipeJson(package.original)},
               {"variant", recipeJson(package.variant)}};
  const std::string hash = contentHash(jsonText(body));
  return jsonText(json{{"hash", hash}, {"package", std::move(body)}}, 2) + "\n";
}

// `directory` stands in messages only.
Result<Package> readFrom(const FileSource& source, const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / kManifest;
  REPRISE_ASSIGN(const std::string text, source(kManifest));
  Package package;
  try {
    const json document = parseJson(text);
    const json& body = document.at("package");
    const int version = integerAt<int>(body, "format_version");
    if (version != kRecipeFormatVersion)
      return manifestError(file, "package.version", "the package has format " + std::to_string(version) + ", this version of Reprise reads format " +
                                                        std::to_string(kRecipeFormatVersion) + "; make the package with it ('reprise emit' or 'optimize')");
    if (document.at("hash") != contentHash(jsonText(body)))
      return manifestError(file, "package.tampered", "the manifest was changed after it was written; run the optimizer again");
    package.tool_version = textAt(body, "tool_version");
    package.interface = interfaceFrom(body.at("interface"));
    package.original = recipeFrom(body.at("original"));
    package.variant = recipeFrom(body.at("variant"));
  } catch (const std::exception& failure) {
    return manifestError(file, "package.manifest", std::string("the manifest cannot be read: ") + failure.what());
  }
  REPRISE_TRY(readModules(package.original, directory, source, package));
  REPRISE_TRY(readModules(package.variant, directory, source, package));
  const Result<void> checked = checkPackage(package);
  if (!checked.ok()) return manifestError(file, checked.error().code, checked.error().message);
  return package;
}

}  // namespace

std::vector<PackageFile> packageFiles(const Package& package) {
  std::vector<PackageFile> files;
  for (const auto& [name, words] : package.modules) files.push_back({name + ".spv", std::string(bytesOf(words))});
  files.push_back({kManifest, manifestText(package)});
  return files;
}

Result<void> writePackageFiles(const Package& package, const std::filesystem::path& directory) {
  for (const auto& [name, text] : package.readable) REPRISE_TRY(writeFile(directory / (name + ".glsl"), text));
  for (const PackageFile& file : packageFiles(package)) REPRISE_TRY(writeFile(directory / file.name, file.bytes));
  return {};
}

Result<Package> readPackage(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / kManifest;
  std::error_code status;
  if (!std::filesystem::exists(file, status))
    return manifestError(file, "package.missing", "there is no package in '" + directory.string() + "' (no manifest.json)");
  return readFrom([&](const std::string& name) { return readFile(directory / name, name == kManifest ? kMostTextBytes : kMostSpirvBytes); }, directory);
}

Result<Package> readEmbeddedPackage(std::span<const EmbeddedFile> files) {
  const FileSource source = [&](const std::string& name) -> Result<std::string> {
    for (const EmbeddedFile& file : files)
      if (name == file.name) return std::string(reinterpret_cast<const char*>(file.bytes), file.size);
    return Error{ErrorKind::kInput, "file.missing", "the embedded package has no file '" + name + "'", {}};
  };
  return readFrom(source, "");
}

}  // namespace reprise
