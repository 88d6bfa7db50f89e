#include "tests/fuzz/reduce_shader.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace reprise {

namespace {

using Lines = std::vector<std::string>;

Lines linesOf(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string textOf(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// The line that closes the last brace of line `start`; `start` where it opens none.
std::size_t endOfBlock(const Lines& lines, std::size_t start) {
  if (lines[start].empty() || lines[start].back() != '{') return start;
  int open = 1;
  for (std::size_t i = start + 1; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const std::size_t first = line.find_first_not_of(' ');
    if (first != std::string::npos && line[first] == '}' && --open == 0) return i;
    if (!line.empty() && line.back() == '{') ++open;
  }
  return start;
}

Lines without(const Lines& lines, std::size_t first, std::size_t last) {
  Lines shorter(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(first));
  shorter.insert(shorter.end(), lines.begin() + static_cast<std::ptrdiff_t>(last) + 1, lines.end());
  return shorter;
}

// What could stand in the place of `lines` with line `at` gone: without its block, or without the braces around it.
std::vector<Lines> attempts(const Lines& lines, std::size_t at) {
  const std::size_t end = endOfBlock(lines, at);
  std::vector<Lines> shorter = {without(lines, at, end)};
  if (end != at) shorter.push_back(without(without(lines, end, end), at, at));
  return shorter;
}

bool reduceOnce(Lines& lines, const std::function<bool(const std::string&)>& shows) {
  bool reduced = false;
  for (std::size_t at = 0; at < lines.size(); ++at)
    for (Lines& shorter : attempts(lines, at))
      if (shows(textOf(shorter))) {
        lines = std::move(shorter);
        reduced = true;
        --at;  // another line stands there now
        break;
      }
  return reduced;
}

}  // namespace

std::string reduceShader(const std::string& text, const std::function<bool(const std::string&)>& shows) {
  Lines lines = linesOf(text);
  while (reduceOnce(lines, shows)) {
  }
  return textOf(lines);
}

}  // namespace reprise
