#include "tests/rules/text_rules.h"

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

namespace reprise::rules {

int lineCount(const SourceFile& file) {
  return static_cast<int>(std::count(file.text.begin(), file.text.end(), '\n'));
}

std::vector<std::string> findLongFiles(const SourceTree& tree, int most_lines) {
  std::vector<std::string> found;
  for (const SourceFile& file : tree) {
    const int lines = lineCount(file);
    if (isCpp(file) && lines > most_lines)
      found.push_back(file.path + ": " + std::to_string(lines) + " lines");
  }
  return found;
}

std::vector<std::string> findMachinePaths(const SourceTree& tree) {
  // An absolute path starts where no path goes on: not after a letter, digit, dot, or another folder's name.
  static const std::regex kMachinePath(
      R"re((^|[^A-Za-z0-9_.\-/}])/(home|root|work|Users|mnt|media|data)/[A-Za-z0-9_.])re");
  std::vector<std::string> found;
  for (const SourceFile& file : tree) {
    std::istringstream lines(file.text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
      if (std::regex_search(line, kMachinePath)) {
        found.push_back(file.path + ":" + std::to_string(number) + ": " + line.substr(0, 120));
      }
    }
  }
  return found;
}

std::vector<std::string> findIdleTests(const SourceTree& tree) {
  static const std::regex kTest(
      R"re((^|\n)\s*(TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\()re");
  std::map<std::string, std::string> build_files;
  for (const SourceFile& file : tree) {
    if (file.path.ends_with("/CMakeLists.txt")) build_files[folderOf(file.path)] = file.text;
  }
  std::vector<std::string> found;
  for (const SourceFile& file : tree) {
    if (!liesBelow(file.path, "tests") || !file.path.ends_with("_test.cpp")) continue;
    const std::string folder = folderOf(file.path);
    const std::string name = file.path.substr(folder.size() + 1);
    if (!std::regex_search(file.text, kTest)) found.push_back(file.path + ": holds no test");
    if (build_files[folder].find(name) == std::string::npos) {
      found.push_back(file.path + ": is not built, " + folder + "/CMakeLists.txt does not name it");
    }
  }
  return found;
}

}  // namespace reprise::rules
