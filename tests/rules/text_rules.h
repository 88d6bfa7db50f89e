// Rules about the files themselves: their length, what they must not mention, and that every test is one and
// is built.
#pragma once

#include <string>
#include <vector>

#include "tests/rules/source_tree.h"

namespace reprise::rules {

inline constexpr int kWantedLines = 400;  // longer files are listed
inline constexpr int kMostLines = 600;    // longer ones fail

int lineCount(const SourceFile& file);

// "path: 512 lines" for each C++ file that is longer than most_lines.
std::vector<std::string> findLongFiles(const SourceTree& tree, int most_lines);

// Paths that exist only on somebody's machine: home folders and the like. "path:line: text" for each.
std::vector<std::string> findMachinePaths(const SourceTree& tree);

// Files below tests/ named *_test.cpp that hold no test, or that the CMakeLists.txt of their folder does not
// name.
std::vector<std::string> findIdleTests(const SourceTree& tree);

}  // namespace reprise::rules
