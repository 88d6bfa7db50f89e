#include "runtime/base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace reprise {
namespace {

constexpr std::size_t kChunkBytes = 65536;

Error unwritable(const std::filesystem::path& path, const std::string& reason) {
  return {ErrorKind::kMachine, "file.unwritable", "cannot write '" + path.string() + "': " + reason, {path.string(), 0, 0}};
}

std::string systemReason() { return std::strerror(errno); }

bool writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// code without its "file.".
Error unreadable(const std::string& code, const std::filesystem::path& path, const std::string& message) {
  return {ErrorKind::kInput, "file." + code, message, {path.string(), 0, 0}};
}

struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

const char* kindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

Error unreachable(const std::filesystem::path& path) {
  if (errno == ENOENT || errno == ENOTDIR) return unreadable("missing", path, "there is no file '" + path.string() + "'");
  return unreadable("unreadable", path, "cannot read '" + path.string() + "': " + systemReason());
}

Result<void> expectRegular(const struct stat& status, const std::filesystem::path& path, std::size_t most_bytes) {
  if (!S_ISREG(status.st_mode))
    return unreadable("not_regular", path, "'" + path.string() + "' is " + kindOf(status.st_mode) + ", expected a regular file");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > most_bytes) return tooLarge(path, size, most_bytes);
  return {};
}

// To the end, whatever size was told before: that of files in /proc is 0, and a file may grow meanwhile.
Result<std::string> readDescriptor(int descriptor, const std::filesystem::path& path, std::size_t expected_bytes, std::size_t most_bytes) {
  std::string bytes;
  std::size_t filled = 0;
  while (true) {
    if (filled > most_bytes)
      return unreadable("too_large", path, "'" + path.string() + "' has more than " + std::to_string(most_bytes) + " bytes, expected at most so many");
    const std::size_t wanted = filled < expected_bytes ? expected_bytes + 1 : filled + std::max(filled, kChunkBytes);
    bytes.resize(std::min(wanted, most_bytes + 1));
    const ssize_t count = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unreadable("unreadable", path, "reading '" + path.string() + "' failed: " + systemReason());
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace

Result<std::string> readFile(const std::filesystem::path& path, std::size_t most_bytes) {
  if (path == "/dev/stdin") return readStandardInput(path, most_bytes);
  // Looked at before it is opened, which devices may notice, and after, as it may have been replaced.
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return unreachable(path);
  REPRISE_TRY(expectRegular(status, path, most_bytes));
  const Descriptor descriptor{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)};
  if (descriptor.number < 0 || ::fstat(descriptor.number, &status) != 0) return unreachable(path);
  REPRISE_TRY(expectRegular(status, path, most_bytes));
  return readDescriptor(descriptor.number, path, static_cast<std::size_t>(status.st_size), most_bytes);
}

Result<std::string> readStandardInput(const std::filesystem::path& name, std::size_t most_bytes) {
  return readDescriptor(STDIN_FILENO, name, 0, most_bytes);
}

Error tooLarge(const std::filesystem::path& path, std::size_t bytes, std::size_t most_bytes) {
  return unreadable("too_large", path, "'" + path.string() + "' has " + std::to_string(bytes) + " bytes, expected at most " + std::to_string(most_bytes));
}

Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code status;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), status);
  if (status) return unwritable(path, status.message());
  const std::string temporary = path.string() + ".tmp" + std::to_string(::getpid());
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return unwritable(path, systemReason());
  const bool written = writeAll(descriptor, bytes) && ::fsync(descriptor) == 0;
  std::string reason = written ? "" : systemReason();
  if (::close(descriptor) != 0 && reason.empty()) reason = systemReason();
  if (reason.empty() && ::rename(temporary.c_str(), path.c_str()) != 0) reason = systemReason();
  if (reason.empty()) return {};
  ::unlink(temporary.c_str());
  return unwritable(path, reason);
}

Result<std::vector<std::uint32_t>> readWords(const std::filesystem::path& path, std::size_t most_bytes) {
  REPRISE_ASSIGN(const std::string bytes, readFile(path, most_bytes));
  if (bytes.size() % 4 != 0)
    return Error{ErrorKind::kInput, "spirv.size",
                 "a SPIR-V file has a whole number of 4-byte words, but this one has " + std::to_string(bytes.size()) +
                     " bytes; it may be cut short",
                 {path.string(), 0, 0}};
  std::vector<std::uint32_t> words(bytes.size() / 4);
  if (!words.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

std::string_view bytesOf(std::span<const std::uint32_t> words) {
  return {reinterpret_cast<const char*>(words.data()), words.size_bytes()};
}

}  // namespace reprise
