// Holds the tree against the rules of the house, and the rules' own checks against made-up trees.
#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <vector>

#include "tests/rules/include_rules.h"
#include "tests/rules/source_tree.h"
#include "tests/rules/text_rules.h"

namespace reprise::rules {
namespace {

std::string joined(const std::vector<std::string>& complaints) {
  std::string text;
  for (const std::string& complaint : complaints) text += complaint + "\n";
  return text;
}

const SourceTree& projectTree() {
  static const SourceTree tree = readSourceTree(REPRISE_SOURCE_DIR);
  return tree;
}

SourceFile including(const std::string& path, const std::string& target) {
  return {path, "#pragma once\n#include \"" + target + "\"\n"};
}

// Complaints about one file that includes one header; the header exists if it is the project's.
std::vector<std::string> complaintsAbout(const std::string& path, const std::string& target) {
  return findForbiddenIncludes({including(path, target), {target, ""}});
}

std::vector<std::string> complaintsAboutThirdParty(const std::string& path, const std::string& target) {
  return findForbiddenIncludes({{path, "#include <" + target + ">\n"}});
}

TEST(Rules, TreeHasOnlyAllowedIncludes) {
  EXPECT_EQ(joined(findForbiddenIncludes(projectTree())), "");
}

TEST(Rules, TreeNamesNobodysMachine) {
  EXPECT_EQ(joined(findMachinePaths(projectTree())), "");
}

TEST(Rules, EveryTestFileHoldsTestsAndIsBuilt) {
  EXPECT_EQ(joined(findIdleTests(projectTree())), "");
}

TEST(Rules, FilesAreShort) {
  std::cout << "longer than " << kWantedLines << " lines:\n"
            << joined(findLongFiles(projectTree(), kWantedLines));
  EXPECT_EQ(joined(findLongFiles(projectTree(), kMostLines)), "");
}

TEST(Rules, EveryFolderOfTheTreeHasARule) {
  std::string without_rule;
  for (const SourceFile& file : projectTree()) {
    if (!isCpp(file)) continue;
    bool covered = false;
    for (const FolderRule& rule : folderRules()) covered = covered || liesBelow(file.path, rule.folder);
    if (!covered) without_rule += file.path + "\n";
  }
  EXPECT_EQ(without_rule, "");
}

TEST(IncludeRules, FindsAnIncludeThatPointsUpwards) {
  const std::vector<std::string> complaints = complaintsAbout("compiler/ir/module.h", "compiler/emit/emit.h");
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_EQ(complaints[0],
            "compiler/ir/module.h:2: \"compiler/emit/emit.h\": compiler/ir may not include compiler/emit");
}

TEST(IncludeRules, AllowsAnIncludeThatPointsDownwards) {
  EXPECT_EQ(joined(complaintsAbout("compiler/emit/emit.h", "compiler/ir/module.h")), "");
}

TEST(IncludeRules, KeepsVulkanOutOfTheCompiler) {
  EXPECT_EQ(complaintsAbout("compiler/source/compile.cpp", "runtime/vulkan/device.h").size(), 1u);
  EXPECT_EQ(complaintsAboutThirdParty("compiler/ir/module.cpp", "vulkan/vulkan.h").size(), 1u);
  EXPECT_EQ(complaintsAboutThirdParty("fitting/solve/solve.cpp", "volk.h").size(), 1u);
  EXPECT_EQ(joined(complaintsAboutThirdParty("runtime/playback/player.h", "vulkan/vulkan_core.h")), "");
}

TEST(IncludeRules, NothingOfTheProductSeesTheCommandLineOrTests) {
  for (const std::string folder :
       {"runtime/playback", "compiler/emit", "profiler/session", "fitting/models"}) {
    EXPECT_EQ(complaintsAbout(folder + "/a.cpp", "cli/pipeline.h").size(), 1u) << folder;
    EXPECT_EQ(complaintsAbout(folder + "/a.cpp", "tests/session/fixture.h").size(), 1u) << folder;
  }
  EXPECT_EQ(complaintsAbout("cli/pipeline.cpp", "tests/session/fixture.h").size(), 1u);
  EXPECT_EQ(complaintsAbout("bench/marble.cpp", "tests/session/fixture.h").size(), 1u);
}

TEST(IncludeRules, TheInterpreterSharesNothingWithWhatItConvicts) {
  const std::string file = "cli/check/interpreter/machine.cpp";
  EXPECT_EQ(complaintsAbout(file, "compiler/ir/module.h").size(), 1u);
  EXPECT_EQ(complaintsAbout(file, "cli/check/verdict.h").size(), 1u);
  EXPECT_EQ(complaintsAboutThirdParty(file, "spirv-tools/libspirv.h").size(), 1u);
  EXPECT_EQ(joined(complaintsAboutThirdParty(file, "spirv/unified1/spirv.hpp11")), "");
  EXPECT_EQ(complaintsAboutThirdParty("cli/check/check_module.cpp", "spirv/unified1/spirv.hpp11").size(), 1u);
}

TEST(IncludeRules, SingleHeaderAllowanceCoversNoOther) {
  EXPECT_EQ(joined(complaintsAbout("profiler/scene/frame_state.h", "runtime/package/interface.h")), "");
  EXPECT_EQ(complaintsAbout("profiler/scene/frame_state.h", "runtime/package/package.h").size(), 1u);
}

TEST(IncludeRules, ThirdPartyHeadersStayInTheirFolders) {
  EXPECT_EQ(joined(complaintsAboutThirdParty("compiler/source/compile.cpp", "glslang/Public/ShaderLang.h")),
            "");
  EXPECT_EQ(complaintsAboutThirdParty("profiler/session/worker.cpp", "glslang/Public/ShaderLang.h").size(),
            1u);
  EXPECT_EQ(complaintsAboutThirdParty("cli/main.cpp", "ceres/ceres.h").size(), 1u);
  EXPECT_EQ(complaintsAboutThirdParty("profiler/session/run.cpp", "sqlite3.h").size(), 1u);
  EXPECT_EQ(complaintsAboutThirdParty("runtime/base/file.cpp", "gtest/gtest.h").size(), 1u);
}

TEST(IncludeRules, HeavyHeadersStayOutOfOurHeaders) {
  EXPECT_EQ(joined(complaintsAboutThirdParty("runtime/package/manifest.cpp", "nlohmann/json.hpp")), "");
  EXPECT_EQ(complaintsAboutThirdParty("fitting/solve/fit.h", "ceres/ceres.h").size(), 1u);
}

TEST(IncludeRules, WantsPathsFromTheRoot) {
  EXPECT_EQ(findForbiddenIncludes({including("runtime/base/file.cpp", "file.h"), {"runtime/base/file.h", ""}})
                .size(),
            1u);
}

TEST(IncludeRules, FindsIncludesThatAreIndented) {
  const SourceTree tree = {{"runtime/base/a.cpp", "#ifdef X\n#  include \"cli/main.h\"\n#endif\n"},
                           {"cli/main.h", ""}};
  EXPECT_EQ(findForbiddenIncludes(tree).size(), 1u);
}

TEST(IncludeRules, TablesNameNoFolderTwice) {
  for (std::size_t i = 0; i < folderRules().size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(folderRules()[i].folder, folderRules()[j].folder);
  }
}

TEST(TextRules, FindsPathsOfSomebodysMachine) {
  const std::string home = std::string("/") + "home" + "/ada/shader.frag";
  EXPECT_EQ(findMachinePaths({{"docs/a.md", "first\nsee " + home + "\n"}}).size(), 1u);
  EXPECT_EQ(findMachinePaths({{"docs/a.md", "\"" + home + "\""}}).size(), 1u);
  EXPECT_EQ(
      joined(findMachinePaths({{"docs/a.md", "https://example.org" + home + ", ../" + home.substr(1)}})), "");
}

TEST(TextRules, CountsLines) {
  const SourceFile file = {"runtime/base/long.cpp", "a\nb\nc\n"};
  EXPECT_EQ(lineCount(file), 3);
  EXPECT_EQ(findLongFiles({file}, 2).size(), 1u);
  EXPECT_EQ(findLongFiles({file}, 3).size(), 0u);
}

TEST(TextRules, FindsTestFilesThatTestNothingOrAreNotBuilt) {
  const std::string test = std::string("TEST") + "(A, B) {}\n";
  const SourceFile build_file = {"tests/a/CMakeLists.txt", "reprise_test(a SOURCES a_test.cpp)"};
  EXPECT_EQ(joined(findIdleTests({build_file, {"tests/a/a_test.cpp", test}})), "");
  EXPECT_EQ(findIdleTests({build_file, {"tests/a/a_test.cpp", "int main() {}\n"}}).size(), 1u);
  EXPECT_EQ(findIdleTests({build_file, {"tests/a/b_test.cpp", test}}).size(), 1u);
}

}  // namespace
}  // namespace reprise::rules
