#include "runtime/base/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace reprise {
namespace {

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

}  // namespace

Result<std::string> readFile(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::exists(path, status))
    return Error{ErrorKind::kInput, "file.missing", "there is no file '" + path.string() + "'", {path.string(), 0, 0}};
  std::ifstream stream(path, std::ios::binary);
  if (std::filesystem::is_directory(path, status) || !stream)
    return Error{ErrorKind::kInput, "file.unreadable", "cannot read '" + path.string() + "' as a file", {path.string(), 0, 0}};
  std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (stream.bad())
    return Error{ErrorKind::kInput, "file.unreadable", "reading '" + path.string() + "' failed", {path.string(), 0, 0}};
  return bytes;
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

Result<std::vector<std::uint32_t>> readWords(const std::filesystem::path& path) {
  REPRISE_ASSIGN(const std::string bytes, readFile(path));
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
