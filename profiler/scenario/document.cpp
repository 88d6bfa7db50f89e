#include "profiler/scenario/document.h"

#include <algorithm>
#include <exception>
#include <sstream>
#include <string_view>
#include <tuple>

#include <toml++/toml.h>

#include "profiler/scenario/names.h"

namespace reprise {
namespace {

Place placeOf(const toml::source_region& region, const std::string& file) {
  return {file, std::max(1, static_cast<int>(region.begin.line)),
          std::max(1, static_cast<int>(region.begin.column))};
}

TomlNode nodeOf(const toml::node& source, const std::string& file);

void fillTable(const toml::table& table, const std::string& file, TomlNode& node) {
  for (const auto& [key, value] : table) {
    node.entries.push_back({std::string(key.str()), placeOf(key.source(), file), nodeOf(value, file)});
  }
  std::stable_sort(node.entries.begin(), node.entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.key_place.line, a.key_place.column) < std::tie(b.key_place.line, b.key_place.column);
  });
}

TomlNode nodeOf(const toml::node& source, const std::string& file) {
  TomlNode node;
  node.place = placeOf(source.source(), file);
  if (const toml::table* table = source.as_table()) {
    node.kind = NodeKind::kTable;
    fillTable(*table, file, node);
  } else if (const toml::array* array = source.as_array()) {
    node.kind = NodeKind::kArray;
    for (const toml::node& element : *array) node.elements.push_back(nodeOf(element, file));
  } else if (const auto* text = source.as_string()) {
    node.kind = NodeKind::kText;
    node.text = text->get();
  } else if (const auto* integer = source.as_integer()) {
    node.kind = NodeKind::kInteger;
    node.integer = integer->get();
    node.real = static_cast<double>(node.integer);
  } else if (const auto* real = source.as_floating_point()) {
    node.kind = NodeKind::kFloat;
    node.real = real->get();
  } else if (const auto* boolean = source.as_boolean()) {
    node.kind = NodeKind::kBoolean;
    node.boolean = boolean->get();
  } else {
    node.kind = NodeKind::kDate;
  }
  return node;
}

// The end of the string or comment that begins at `at`; `at` itself where none does.
std::size_t skipQuoted(const std::string& toml, std::size_t at) {
  const char quote = toml[at];
  if (quote == '#') return std::min(toml.find('\n', at), toml.size());
  if (quote != '"' && quote != '\'') return at;
  const bool several_lines = toml.compare(at, 3, std::string(3, quote)) == 0;
  const std::size_t width = several_lines ? 3 : 1;
  for (at += width; at < toml.size(); ++at) {
    if (toml[at] == '\\' && quote == '"') {
      ++at;
    } else if (toml.compare(at, width, std::string(width, quote)) == 0) {
      return at + width;
    } else if (toml[at] == '\n' && !several_lines) {
      return at;
    }
  }
  return toml.size();
}

// The line of the first key of more than kMaxKeyParts parts, 0 if there is none. Looked for in the text: the parser takes keys
// of any length and leaves their tables by recursion.
int lineOfLongKey(const std::string& toml) {
  int line = 1, dots = 0;
  for (std::size_t at = 0; at < toml.size();) {
    const std::size_t end = skipQuoted(toml, at);
    if (end != at) {
      line += static_cast<int>(std::count(toml.begin() + static_cast<std::ptrdiff_t>(at), toml.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      at = end;
      continue;
    }
    const char letter = toml[at++];
    line += letter == '\n';
    if (letter == '.' && ++dots >= kMaxKeyParts) return line;
    if (std::string_view("=[]{},\n").find(letter) != std::string_view::npos) dots = 0;
  }
  return 0;
}

Error syntaxError(const std::string& reason, const Place& place) {
  return {ErrorKind::kInput, "scenario.syntax", "this is no valid TOML: " + reason, place};
}

}  // namespace

Result<TomlNode> parseDocument(const std::string& toml, const std::string& file) {
  if (const int line = lineOfLongKey(toml); line > 0)
    return syntaxError("a key has more than " + std::to_string(kMaxKeyParts) + " parts", {file, line, 1});
  try {
    return nodeOf(toml::parse(toml, file), file);
  } catch (const toml::parse_error& problem) {
    return syntaxError(std::string(problem.description()), placeOf(problem.source(), file));
  } catch (const std::exception& problem) {
    return syntaxError(problem.what(), {file, 0, 0});
  }
}

std::string describeNode(const TomlNode& node) {
  std::ostringstream text;
  switch (node.kind) {
    case NodeKind::kBoolean:
      text << "the boolean " << (node.boolean ? "true" : "false");
      break;
    case NodeKind::kInteger:
      text << "the integer " << node.integer;
      break;
    case NodeKind::kFloat:
      text << "the number " << node.real;
      break;
    case NodeKind::kText:
      text << "the text '" << node.text.substr(0, 60) << "'";
      break;
    case NodeKind::kArray:
      text << "an array of " << node.elements.size();
      break;
    case NodeKind::kTable:
      text << "a table";
      break;
    case NodeKind::kDate:
      text << "a date or time";
      break;
  }
  return text.str();
}

}  // namespace reprise
