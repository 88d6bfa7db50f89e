// Messages between processes over pipes: a head of text and a body of words.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace reprise {

struct PipeMessage {
  std::string head;  // JSON
  std::vector<std::uint32_t> body;
};

// All of it, or false (the other side is gone).
bool writeAll(int descriptor, const void* bytes, std::size_t size);
bool sendMessage(int descriptor, const PipeMessage& message);

// The next message; nothing once the other side is gone, or `given_up`, asked some times a second, says so.
std::optional<PipeMessage> receiveMessage(int descriptor, const std::function<bool()>& given_up = {});

}  // namespace reprise
