// Who may include whom, as two tables, and the check of a tree against them.
//
// A folder's rule is the one of the longest prefix that has a rule. It may include itself, runtime/base, and
// what its rule lists: folders, or single headers. A third-party header is known by its prefix and may be
// included only below the listed folders; one that is not in the table may be included anywhere.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/rules/source_tree.h"

namespace reprise::rules {

struct FolderRule {
  std::string folder;
  std::vector<std::string> may_include;  // folders, or headers ("runtime/package/interface.h")
};

struct ThirdPartyRule {
  std::string library;
  std::vector<std::string> prefixes;  // of the name in #include
  std::vector<std::string> folders;   // where it may be included
  bool in_headers = false;            // whether our headers may include it, too
};

// The rules of this project.
std::span<const FolderRule> folderRules();
std::span<const ThirdPartyRule> thirdPartyRules();

// "runtime/base/file.h:12: ..." for each #include that breaks a rule, in the order of the tree.
std::vector<std::string> findForbiddenIncludes(const SourceTree& tree);

}  // namespace reprise::rules
