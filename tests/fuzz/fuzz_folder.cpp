#include "tests/fuzz/fuzz_folder.h"

#include <unistd.h>

#include <fstream>

namespace reprise {

namespace fs = std::filesystem;

FuzzFolder::FuzzFolder() : path_(fs::temp_directory_path() / ("reprise_fuzz_" + std::to_string(::getpid()))) {
  fs::create_directories(path_);
}

FuzzFolder::~FuzzFolder() {
  std::error_code status;
  fs::remove_all(path_, status);
}

fs::path FuzzFolder::write(const std::string& name, std::string_view bytes) const {
  const fs::path file = path_ / name;
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

}  // namespace reprise
