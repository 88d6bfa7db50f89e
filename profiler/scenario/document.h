// A TOML file as a tree of plain values, each with its place; tables keep the order of the file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

enum class NodeKind { kBoolean, kInteger, kFloat, kText, kArray, kTable, kDate };

struct Entry;

struct TomlNode {
  NodeKind kind = NodeKind::kTable;
  Place place;
  bool boolean = false;
  std::int64_t integer = 0;
  double real = 0;  // of integers, too
  std::string text;
  std::vector<TomlNode> elements;  // of an array
  std::vector<Entry> entries;  // of a table

  bool isNumber() const { return kind == NodeKind::kInteger || kind == NodeKind::kFloat; }
};

struct Entry {
  std::string key;
  Place key_place;
  TomlNode value;
};

// `file` stands in the places. Errors: scenario.syntax.
Result<TomlNode> parseDocument(const std::string& toml, const std::string& file);

// What was found, for messages: "the text 'eight'", "the integer -64", "an array of 3".
std::string describeNode(const TomlNode& node);

}  // namespace reprise
