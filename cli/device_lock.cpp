#include "cli/device_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

constexpr std::chrono::milliseconds kPollInterval{200};
constexpr std::size_t kMostHolderText = 300, kMostHolderBytes = 65536;

std::string holderIn(const std::string& file) {
  const Result<std::string> text = readFile(file, kMostHolderBytes);
  if (!text.ok() || text->empty()) return "another process";
  std::string line = text->substr(0, std::min(text->find('\n'), kMostHolderText));
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return line;
}

// Another user's file cannot be created anew in a shared folder, but it can be read and locked.
int openLock(const std::string& file) {
  for (const int flags : {O_RDWR, O_RDWR | O_CREAT, O_RDONLY}) {
    const int descriptor = ::open(file.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor >= 0) return descriptor;
  }
  return -1;
}

}  // namespace

std::string deviceLockFile(const std::string& device) {
  std::error_code status;
  std::filesystem::path folder = std::filesystem::temp_directory_path(status);
  if (status) folder = "/tmp";
  return (folder / ("reprise-device-" + contentHash(device).substr(0, 16) + ".lock")).string();
}

Result<DeviceLock> DeviceLock::take(const std::string& device, const std::string& command, const Waiting& waiting) {
  const std::string file = deviceLockFile(device);
  DeviceLock lock;
  lock.descriptor_ = openLock(file);
  if (lock.descriptor_ < 0) return lock;
  for (bool told = false; ::flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0; told = true) {
    if (!told && waiting.told) waiting.told(holderIn(file));
    if (waiting.interrupted && waiting.interrupted())
      return Error{ErrorKind::kInterrupted, "run.interrupted", "interrupted while waiting for the device", {}};
    std::this_thread::sleep_for(kPollInterval);
  }
  const std::string holder = "process " + std::to_string(::getpid()) + ": " + command + "\n";
  if (::ftruncate(lock.descriptor_, 0) == 0) {
    // Who holds it is told as far as that can be written.
    const ssize_t written = ::pwrite(lock.descriptor_, holder.data(), holder.size(), 0);
    static_cast<void>(written);
  }
  return lock;
}

DeviceLock::DeviceLock(DeviceLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

DeviceLock& DeviceLock::operator=(DeviceLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

DeviceLock::~DeviceLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace reprise
