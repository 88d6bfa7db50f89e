// A directory of its own for a test's files, gone when the test ends.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "runtime/base/file.h"

namespace reprise {

class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "reprise-test-XXXXXX").string();
    REPRISE_CHECK(::mkdtemp(pattern.data()) != nullptr, pattern);
    path_ = pattern;
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

  // Writes a file below the directory and returns its path.
  std::filesystem::path write(const std::string& name, std::string_view text) const {
    const Result<void> written = writeFile(path_ / name, text);
    REPRISE_CHECK(written.ok(), name);
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace reprise
