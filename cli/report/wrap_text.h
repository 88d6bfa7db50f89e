// Text for a terminal: lines of at most kColumns columns. A column is a code point.
#pragma once

#include <cstddef>
#include <string>

namespace reprise {

inline constexpr std::size_t kColumns = 80;

std::size_t columnsOf(const std::string& text);

// The bytes of the first `columns` code points.
std::size_t bytesOfColumns(const std::string& text, std::size_t columns);

// Appends `text`, made printable, in lines of at most kColumns with a line feed after each; the first one starts with `head`, the others
// with as many spaces. A word that is longer than a line is broken.
void wrap(std::string& out, const std::string& head, const std::string& text);

}  // namespace reprise
