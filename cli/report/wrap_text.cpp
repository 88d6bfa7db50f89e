#include "cli/report/wrap_text.h"

#include <algorithm>

#include "cli/report/text.h"

namespace reprise {

std::size_t columnsOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::size_t bytesOfColumns(const std::string& text, std::size_t columns) {
  std::size_t at = 0;
  while (at < text.size()) {
    if ((text[at] & 0xC0) != 0x80 && columns-- == 0) break;
    ++at;
  }
  return at;
}

void wrap(std::string& out, const std::string& head, const std::string& text) {
  const std::string indent(columnsOf(head), ' ');
  std::string line = head;
  bool line_empty = true;
  const auto flush = [&] {
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    line = indent;
    line_empty = true;
  };
  std::string rest = printable(text);
  while (!rest.empty()) {
    const std::size_t word_end = std::min(rest.find(' '), rest.size());
    std::string word = rest.substr(0, word_end);
    rest.erase(0, word_end + (word_end < rest.size() ? 1 : 0));
    if (!line_empty && columnsOf(line) + 1 + columnsOf(word) > kColumns) flush();
    if (!line_empty) line += ' ';
    while (columnsOf(line) + columnsOf(word) > kColumns) {
      const std::size_t fitting = bytesOfColumns(word, kColumns - columnsOf(line));
      line += word.substr(0, fitting);
      word.erase(0, fitting);
      flush();
    }
    line += word;
    line_empty = false;
  }
  flush();
}

}  // namespace reprise
