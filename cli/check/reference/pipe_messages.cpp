#include "cli/check/reference/pipe_messages.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>

namespace reprise {
namespace {

constexpr int kPollMilliseconds = 50;
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 31;  // of a message: more is nonsense

struct Sizes {
  std::uint64_t head_bytes = 0, body_words = 0;
};

bool readAll(int descriptor, void* bytes, std::size_t size, const std::function<bool()>& given_up) {
  char* place = static_cast<char*>(bytes);
  while (size > 0) {
    if (given_up) {
      pollfd polled{descriptor, POLLIN, 0};
      if (::poll(&polled, 1, kPollMilliseconds) <= 0 || (polled.revents & (POLLIN | POLLHUP)) == 0) {
        if (given_up()) return false;
        continue;
      }
    }
    const ssize_t count = ::read(descriptor, place, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    place += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace

bool writeAll(int descriptor, const void* bytes, std::size_t size) {
  const char* place = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t written = ::write(descriptor, place, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    place += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

bool sendMessage(int descriptor, const PipeMessage& message) {
  const Sizes sizes{message.head.size(), message.body.size()};
  return writeAll(descriptor, &sizes, sizeof sizes) && writeAll(descriptor, message.head.data(), message.head.size()) &&
         writeAll(descriptor, message.body.data(), message.body.size() * sizeof(std::uint32_t));
}

std::optional<PipeMessage> receiveMessage(int descriptor, const std::function<bool()>& given_up) {
  Sizes sizes;
  if (!readAll(descriptor, &sizes, sizeof sizes, given_up)) return std::nullopt;
  if (sizes.head_bytes > kMostBytes || sizes.body_words > kMostBytes / sizeof(std::uint32_t)) return std::nullopt;
  PipeMessage message;
  message.head.resize(sizes.head_bytes);
  message.body.resize(sizes.body_words);
  if (!readAll(descriptor, message.head.data(), message.head.size(), given_up)) return std::nullopt;
  if (!readAll(descriptor, message.body.data(), message.body.size() * sizeof(std::uint32_t), given_up)) return std::nullopt;
  return message;
}

}  // namespace reprise
