#include "cli/write_changed.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <set>
#include <string>
#include <vector>

#include "compiler/emit/emit.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "manifest.json";
constexpr std::string_view kAside = ".new-";  // and the number of the process

// Removed at the end of its life with all that is in it.
class AsideFolder {
 public:
  explicit AsideFolder(fs::path path) : path_(std::move(path)) {}
  AsideFolder(const AsideFolder&) = delete;
  AsideFolder& operator=(const AsideFolder&) = delete;
  ~AsideFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Folders that processes left aside which were killed on the way.
void removeAbandoned(const fs::path& directory) {
  std::error_code status;
  std::vector<fs::path> abandoned;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, status)) {
    const std::string name = entry.path().filename().string();
    pid_t process = 0;
    if (!name.starts_with(kAside)) continue;
    const auto [end, failure] = std::from_chars(name.data() + kAside.size(), name.data() + name.size(), process);
    if (failure != std::errc() || end != name.data() + name.size() || process <= 0) continue;
    if (::kill(process, 0) != 0 && errno == ESRCH) abandoned.push_back(entry.path());
  }
  for (const fs::path& folder : abandoned) fs::remove_all(folder, status);
}

bool sameBytes(const fs::path& file, std::string_view bytes) {
  std::error_code status;
  if (!fs::is_regular_file(file, status) || fs::file_size(file, status) != bytes.size()) return false;
  const Result<std::string> old = readFile(file, bytes.size());
  return old.ok() && *old == bytes;
}

// The manifest last: until it is replaced, readers find the old one, whose hashes tell them of a change under way.
std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::stable_partition(files.begin(), files.end(), [](const fs::path& file) { return file.filename() != kManifest; });
  return files;
}

}  // namespace

Result<bool> writeIfChanged(const fs::path& file, std::string_view bytes) {
  if (sameBytes(file, bytes)) return false;
  REPRISE_TRY(writeFile(file, bytes));
  return true;
}

Result<bool> writePackageIfChanged(const Package& package, const fs::path& directory) {
  std::set<std::string> outdated;
  std::error_code status;
  if (fs::exists(directory, status) && !fs::is_directory(directory, status))
    return Error{ErrorKind::kInput, "output.not_a_directory", "the output '" + directory.string() + "' is a file; name a directory with -o", {}};
  if (fs::exists(directory / kManifest, status))
    if (const Result<Package> old = readPackage(directory); old.ok())
      for (const auto& [name, words] : old->modules) outdated.insert(name);
  removeAbandoned(directory);
  const AsideFolder aside(directory / (std::string(kAside) + std::to_string(::getpid())));
  REPRISE_TRY(writePackage(package, aside.path()));
  bool changed = false;
  for (const fs::path& file : filesIn(aside.path())) {
    REPRISE_ASSIGN(const std::string bytes, readFile(file));
    if (sameBytes(directory / file.filename(), bytes)) continue;
    fs::rename(file, directory / file.filename(), status);
    if (status)
      return Error{ErrorKind::kMachine, "file.unwritable", "cannot write '" + (directory / file.filename()).string() + "': " + status.message(), {}};
    changed = true;
  }
  for (const auto& [name, words] : package.modules) outdated.erase(name);
  for (const std::string& name : outdated)
    for (const char* suffix : {".spv", ".glsl"}) changed |= fs::remove(directory / (name + suffix), status);
  return changed;
}

}  // namespace reprise
