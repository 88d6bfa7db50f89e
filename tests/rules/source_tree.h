// The project's files as plain values, so that the rules can be held against the real tree and against
// made-up ones.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace reprise::rules {

struct SourceFile {
  std::string path;  // from the root of the project, with '/': "runtime/base/file.h"
  std::string text;
};
using SourceTree = std::vector<SourceFile>;  // by path

// All text files below root. Build and output folders, hidden folders other than .ci, and files that hold a
// zero byte are left out.
SourceTree readSourceTree(const std::filesystem::path& root);

bool isCpp(const SourceFile& file);     // .h, .cpp
bool isHeader(const SourceFile& file);  // .h

// "a/b/c.h" lies below "a/b" and below "a", not below "a/bc".
bool liesBelow(const std::string& path, const std::string& folder);

// "a/b" of "a/b/c.h"; empty for a file at the root.
std::string folderOf(const std::string& path);

}  // namespace reprise::rules
