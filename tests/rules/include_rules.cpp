#include "tests/rules/include_rules.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace reprise::rules {

namespace {

// The compiler's stages, lowest first: each may include those before it.
const std::string kSource = "compiler/source", kIr = "compiler/ir", kAnalysis = "compiler/analysis",
                  kCandidates = "compiler/candidates", kTransforms = "compiler/transforms",
                  kStrategies = "compiler/strategies", kEmit = "compiler/emit";

const std::vector<FolderRule> kFolderRules = {
    {"runtime/base", {}},
    {"runtime/package", {}},
    {"runtime/vulkan", {}},
    {"runtime/playback", {"runtime/package", "runtime/vulkan"}},
    {kSource, {"runtime/package"}},
    {kIr, {kSource}},
    {kAnalysis, {kSource, kIr}},
    {kCandidates, {kSource, kIr, kAnalysis, "runtime/package"}},
    {kTransforms, {kSource, kIr, kAnalysis, kCandidates, "runtime/package"}},
    {kStrategies, {kSource, kIr, kAnalysis, kCandidates, kTransforms, "runtime/package"}},
    {kEmit, {kSource, kIr, kAnalysis, kCandidates, kTransforms, kStrategies, "runtime/package"}},
    {"profiler/gltf", {}},
    {"profiler/scenario", {"profiler/gltf", "runtime/package/interface.h"}},
    {"profiler/scene", {"profiler/gltf", "profiler/scenario", "runtime/package/interface.h"}},
    {"profiler/metrics", {}},
    {"profiler/measurements", {}},
    {"profiler/session",
     {"runtime", "profiler/gltf", "profiler/scenario", "profiler/scene", "profiler/metrics", "profiler/measurements"}},
    {"profiler/harness", {"runtime", "profiler/scenario", "profiler/scene"}},
    {"profiler/training",
     {"runtime", "profiler/scenario", "profiler/scene", "profiler/metrics", "profiler/measurements",
      "profiler/session"}},
    {"fitting", {"profiler/measurements"}},
    {"cli", {"runtime", "compiler", "profiler", "fitting"}},
    // The reference of `check`: no pass of ours, and nothing that reads a module into our IR.
    {"cli/check/reference", {"runtime", kSource, "profiler/harness"}},
    // Convicts compiler/ir, so it may share nothing with it.
    {"cli/check/interpreter", {}},
    // Not part of the product: they may see all of it, and nothing of it sees them.
    {"tests", {"runtime", "compiler", "profiler", "fitting", "cli"}},
    {"bench", {"runtime", "compiler", "profiler", "fitting", "cli"}},
    // An example is an application: it sees what `cmake --install` gives it.
    {"examples", {"runtime/package", "runtime/vulkan", "runtime/playback"}},
};

// A test folder may use what the folder that it tests may use.
const std::vector<ThirdPartyRule> kThirdPartyRules = {
    {"glslang", {"glslang/", "SPIRV/"}, {"compiler", "tests/compiler"}},
    {"SPIRV-Tools", {"spirv-tools/"}, {"compiler", "tests/compiler", "tests/fuzz"}},
    {"SPIRV-Cross", {"spirv_cross/"}, {"compiler", "tests/compiler"}},
    {"SPIRV-Headers", {"spirv/"}, {"compiler", "cli/check/interpreter", "tests/compiler"}, true},
    {"Ceres", {"ceres/", "Eigen/"}, {"fitting", "tests/fitting"}},
    {"SQLite", {"sqlite3.h"}, {"profiler/measurements", "tests/measurements"}},
    {"Vulkan",
     {"vulkan/", "volk.h", "volk.c"},
     {"runtime/vulkan", "runtime/playback", "profiler/session", "profiler/harness", "cli", "tests", "bench", "examples"},
     true},
    {"tinygltf", {"tiny_gltf.h"}, {"profiler/gltf", "tests/gltf"}},
    {"toml++", {"toml++/", "toml.hpp"}, {"profiler/scenario", "tests"}},
    // In headers, too: runtime/package/json_values.h holds templates that its .cpp files share.
    {"nlohmann-json", {"nlohmann/"}, {"runtime", "compiler", "profiler", "fitting", "cli", "tests", "bench"}, true},
    {"CLI11", {"CLI/"}, {"cli", "bench"}},
    {"GoogleTest", {"gtest/", "gmock/"}, {"tests"}, true},
    {"RapidCheck", {"rapidcheck.h", "rapidcheck/"}, {"tests"}, true},
};

struct Include {
  std::string target;
  bool quoted = false;
  int line = 0;
};

std::vector<Include> includesOf(const SourceFile& file) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re");
  std::vector<Include> includes;
  std::istringstream lines(file.text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, kInclude)) includes.push_back({match[2], match[1] == "\"", number});
  }
  return includes;
}

const FolderRule* ruleOf(const std::string& path) {
  const FolderRule* best = nullptr;
  for (const FolderRule& rule : kFolderRules) {
    if (liesBelow(path, rule.folder) && (!best || rule.folder.size() > best->folder.size())) best = &rule;
  }
  return best;
}

bool mayInclude(const FolderRule& rule, const std::string& target) {
  const auto covers = [&](const std::string& allowed) {
    return target == allowed || liesBelow(target, allowed);
  };
  return covers(rule.folder) || covers("runtime/base") ||
         std::any_of(rule.may_include.begin(), rule.may_include.end(), covers);
}

// Empty if the include is fine, else what is wrong with it.
std::string judgeOwn(const SourceFile& file, const std::string& target) {
  const FolderRule* rule = ruleOf(file.path);
  if (!rule) return "lies in a folder that has no rule";
  if (mayInclude(*rule, target)) return "";
  return rule->folder + " may not include " + folderOf(target);
}

std::string judgeThirdParty(const SourceFile& file, const std::string& target) {
  for (const ThirdPartyRule& rule : kThirdPartyRules) {
    const bool named = std::any_of(rule.prefixes.begin(), rule.prefixes.end(),
                                   [&](const std::string& prefix) { return target.starts_with(prefix); });
    if (!named) continue;
    const bool allowed = std::any_of(rule.folders.begin(), rule.folders.end(),
                                     [&](const std::string& folder) { return liesBelow(file.path, folder); });
    if (!allowed) return rule.library + " has no place in " + folderOf(file.path);
    if (isHeader(file) && !rule.in_headers) return rule.library + " belongs in .cpp files, not in headers";
    return "";
  }
  return "";
}

}  // namespace

std::span<const FolderRule> folderRules() {
  return kFolderRules;
}
std::span<const ThirdPartyRule> thirdPartyRules() {
  return kThirdPartyRules;
}

std::vector<std::string> findForbiddenIncludes(const SourceTree& tree) {
  std::set<std::string> own;
  for (const SourceFile& file : tree) own.insert(file.path);

  std::vector<std::string> complaints;
  for (const SourceFile& file : tree) {
    if (!isCpp(file)) continue;
    for (const Include& include : includesOf(file)) {
      std::string complaint;
      if (own.contains(include.target)) {
        complaint = judgeOwn(file, include.target);
      } else if (include.quoted && own.contains(folderOf(file.path) + "/" + include.target)) {
        // An example is built by its own CMake project, whose root is its own folder.
        if (!liesBelow(file.path, "examples")) complaint = "write the path from the root of the project";
      } else {
        complaint = judgeThirdParty(file, include.target);
      }
      if (!complaint.empty()) {
        complaints.push_back(file.path + ":" + std::to_string(include.line) + ": \"" + include.target +
                             "\": " + complaint);
      }
    }
  }
  return complaints;
}

}  // namespace reprise::rules
