#include "cli/workspace.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "compiler/strategies/build_package.h"
#include "runtime/base/hash.h"

namespace reprise {

Result<Workspace> Workspace::open(const std::filesystem::path& directory) {
  std::error_code status;
  if (std::filesystem::exists(directory, status) && !std::filesystem::is_directory(directory, status))
    return Error{ErrorKind::kInput, "output.not_a_directory",
                 "the output '" + directory.string() + "' is a file; name a directory with -o", {}};
  Workspace workspace;
  workspace.root_ = std::filesystem::absolute(directory);
  std::filesystem::create_directories(workspace.root_ / "work" / "variants", status);
  if (status)
    return Error{ErrorKind::kMachine, "file.unwritable", "cannot make '" + directory.string() + "': " + status.message(), {}};
  const std::string lock_file = (workspace.root_ / "work" / "lock").string();
  workspace.lock_ = ::open(lock_file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (workspace.lock_ < 0)
    return Error{ErrorKind::kMachine, "file.unwritable", "cannot write '" + lock_file + "': " + std::strerror(errno), {}};
  if (::flock(workspace.lock_, LOCK_EX | LOCK_NB) != 0)
    return Error{ErrorKind::kInput, "output.busy",
                 "another run of Reprise is writing to '" + directory.string() + "'; wait for it or choose another directory", {}};
  return workspace;
}

Workspace::Workspace(Workspace&& other) noexcept : root_(std::move(other.root_)), lock_(std::exchange(other.lock_, -1)) {}

Workspace& Workspace::operator=(Workspace&& other) noexcept {
  if (this == &other) return *this;
  if (lock_ >= 0) ::close(lock_);
  root_ = std::move(other.root_);
  lock_ = std::exchange(other.lock_, -1);
  return *this;
}

Workspace::~Workspace() {
  if (lock_ >= 0) ::close(lock_);
}

Result<StoredVariant> storeVariant(const Workspace& workspace, const ShaderProgram& program, const Candidate& candidate,
                                   const VariantOptions& options, const StateLimits& limits) {
  // One package for all periods; what takes from the other eye has but one.
  VariantOptions at_one_period = options;
  at_one_period.period_frames = options.previous == PreviousImage::kOtherEye ? 2 : 1;
  REPRISE_ASSIGN(Package package, buildPackage(program, candidate, at_one_period, limits));
  StoredVariant stored;
  stored.recipe = package.variant;
  stored.hash = contentHash(recipeToJson(package.variant));
  stored.dir = (workspace.root() / "work" / "variants" / stored.hash).string();
  package.tool_version = "";
  if (!std::filesystem::exists(std::filesystem::path(stored.dir) / "manifest.json")) REPRISE_TRY(writePackageFiles(package, stored.dir));
  return stored;
}

}  // namespace reprise
