// A folder of the fuzzer's own, for readers that take paths. Removed when the program ends by itself.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace reprise {

class FuzzFolder {
 public:
  FuzzFolder();
  ~FuzzFolder();
  FuzzFolder(const FuzzFolder&) = delete;
  FuzzFolder& operator=(const FuzzFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  // Unlike writeFile, without waiting for the disk.
  std::filesystem::path write(const std::string& name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

}  // namespace reprise
