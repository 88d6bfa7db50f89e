#include "tests/rules/source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace reprise::rules {

namespace fs = std::filesystem;

SourceTree readSourceTree(const fs::path& root) {
  static const std::set<std::string> kSkipped = {"build", "out"};
  SourceTree tree;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator();
       ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory()) {
      const bool at_root = entry.depth() == 0;
      if ((name.starts_with('.') && name != ".ci") || (at_root && kSkipped.contains(name))) {
        entry.disable_recursion_pending();
      }
      continue;
    }
    if (!entry->is_regular_file()) continue;
    std::ifstream stream(entry->path(), std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (text.find('\0') != std::string::npos) continue;
    tree.push_back({entry->path().lexically_relative(root).generic_string(), std::move(text)});
  }
  std::sort(tree.begin(), tree.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return tree;
}

bool isHeader(const SourceFile& file) {
  return file.path.ends_with(".h");
}

bool isCpp(const SourceFile& file) {
  return isHeader(file) || file.path.ends_with(".cpp");
}

bool liesBelow(const std::string& path, const std::string& folder) {
  return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

std::string folderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

}  // namespace reprise::rules
