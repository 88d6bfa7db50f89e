// Finds the files that #include directives name, keeps their texts, and remembers why one was not found.
//
// Quoted names are looked for beside the including file first; then, as bracketed names, in the include
// directories in order. Nesting deeper than kMaxIncludeDepth is taken for a cycle, as is a shader whose
// includes exceed kMaxIncludeBytes altogether (two files that include each other twice grow without end
// before they grow deep).
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compiler/source/compile.h"

namespace reprise {

inline constexpr std::size_t kMaxIncludeDepth = 64;
inline constexpr std::size_t kMaxIncludeBytes = std::size_t{64} << 20;

class IncludeResolver {
 public:
  IncludeResolver(std::string main_path, std::vector<std::filesystem::path> include_dirs);

  // The file for `name`, which stays valid as long as the resolver; null if it is not beside `includer` (or,
  // from the second function, in no include directory) or if an earlier include failed. Each file returned
  // counts as open until close() is called; the last opened is closed first.
  const SourceFile* openBeside(const std::string& name, const std::string& includer);
  const SourceFile* openFromDirectories(const std::string& name, const std::string& includer);
  void close();

  // Files in order of first inclusion, each once.
  const std::deque<SourceFile>& files() const { return files_; }
  // The first include that failed, without a line: source.include, or that of readFile.
  const std::optional<Error>& failure() const { return failure_; }

 private:
  const SourceFile* open(const std::filesystem::path& path);
  void failCycle(const std::string& path);

  std::string main_path_;
  std::vector<std::filesystem::path> include_dirs_;
  std::deque<SourceFile> files_;
  std::vector<std::string> open_paths_;
  std::size_t included_bytes_ = 0;
  std::optional<Error> failure_;
};

}  // namespace reprise
