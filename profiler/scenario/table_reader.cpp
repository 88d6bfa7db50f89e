#include "profiler/scenario/table_reader.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "profiler/scenario/near_names.h"

namespace reprise {
namespace {

std::string describeRange(const std::string& noun, Range range) {
  std::ostringstream text;
  text.precision(10);
  text << noun;
  if (range.high >= 1e9) {
    if (range.low_open)
      text << " above " << range.low;
    else if (range.low > -1e9)
      text << " of at least " << range.low;
  } else {
    text << (range.low_open ? " above " : " from ") << range.low << (range.low_open ? " and up to " : " to ")
         << range.high;
  }
  return text.str();
}

bool within(double value, Range range) {
  return (range.low_open ? value > range.low : value >= range.low) && value <= range.high;
}

bool integerOf(const TomlNode& node, const std::string& what, Range range, Diagnostics& diagnostics) {
  const std::string message =
      what + " is " + describeNode(node) + ", expected " + describeRange("an integer", range);
  if (node.kind != NodeKind::kInteger)
    diagnostics.add("type", message, node.place);
  else if (!within(node.real, range))
    diagnostics.add("value", message, node.place);
  else
    return true;
  return false;
}

}  // namespace

bool numberOf(const TomlNode& node, const std::string& what, Range range, float& value,
              Diagnostics& diagnostics) {
  const std::string message =
      what + " is " + describeNode(node) + ", expected " + describeRange("a number", range);
  if (!node.isNumber()) {
    diagnostics.add("type", message, node.place);
    return false;
  }
  // The narrowing to float must not turn a positive number into 0.
  if (!std::isfinite(node.real) || !within(node.real, range) ||
      !within(static_cast<float>(node.real), range)) {
    diagnostics.add("value", message, node.place);
    return false;
  }
  value = static_cast<float>(node.real);
  return true;
}

TableReader::TableReader(const TomlNode& table, std::string what, Diagnostics& diagnostics)
    : table_(table), what_(std::move(what)), diagnostics_(diagnostics) {
  if (table.kind != NodeKind::kTable) {
    diagnostics_.add("type", what_ + " is " + describeNode(table) + ", expected a table { key = value, ... }",
                     table.place);
  }
}

bool TableReader::has(const std::string& key) const {
  return std::any_of(table_.entries.begin(), table_.entries.end(),
                     [&](const Entry& entry) { return entry.key == key; });
}

const TomlNode* TableReader::find(const std::string& key, Need need) {
  known_.push_back(key);
  for (const Entry& entry : table_.entries) {
    if (entry.key == key) return &entry.value;
  }
  if (need == Need::kRequired && table_.kind == NodeKind::kTable) {
    diagnostics_.add("missing_key", what_ + " needs the key '" + key + "'", table_.place);
  }
  return nullptr;
}

void TableReader::readText(const std::string& key, std::string& value, Need need) {
  const TomlNode* node = find(key, need);
  if (!node) return;
  if (node->kind != NodeKind::kText) {
    diagnostics_.add(
        "type", "'" + key + "' of " + what_ + " is " + describeNode(*node) + ", expected a text in quotes",
        node->place);
  } else if (node->text.empty()) {
    diagnostics_.add("value", "'" + key + "' of " + what_ + " is empty", node->place);
  } else {
    value = node->text;
  }
}

void TableReader::readBoolean(const std::string& key, bool& value) {
  const TomlNode* node = find(key);
  if (!node) return;
  if (node->kind == NodeKind::kBoolean) {
    value = node->boolean;
  } else {
    diagnostics_.add("type",
                     "'" + key + "' of " + what_ + " is " + describeNode(*node) + ", expected true or false",
                     node->place);
  }
}

void TableReader::readNumber(const std::string& key, float& value, Range range) {
  if (const TomlNode* node = find(key)) numberOf(*node, "'" + key + "' of " + what_, range, value, diagnostics_);
}

void TableReader::readNumbers(const std::string& key, std::span<float> value, Range range) {
  const TomlNode* node = find(key);
  if (!node) return;
  const std::string name = "'" + key + "' of " + what_;
  if (node->kind != NodeKind::kArray || node->elements.size() != value.size()) {
    diagnostics_.add("type",
                     name + " is " + describeNode(*node) + ", expected an array of " +
                         std::to_string(value.size()) + " numbers",
                     node->place);
    return;
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    numberOf(node->elements[i], "element " + std::to_string(i + 1) + " of " + name, range, value[i],
             diagnostics_);
  }
}

void TableReader::readInteger(const std::string& key, int& value, Range range) {
  const TomlNode* node = find(key);
  if (node && integerOf(*node, "'" + key + "' of " + what_, range, diagnostics_))
    value = static_cast<int>(node->integer);
}

void TableReader::readUnsigned(const std::string& key, std::uint32_t& value, Range range) {
  const TomlNode* node = find(key);
  if (node && integerOf(*node, "'" + key + "' of " + what_, range, diagnostics_))
    value = static_cast<std::uint32_t>(node->integer);
}

std::vector<const TomlNode*> TableReader::findTables(const std::string& key) {
  const TomlNode* node = find(key);
  std::vector<const TomlNode*> tables;
  if (!node) return tables;
  if (node->kind != NodeKind::kArray) {
    diagnostics_.add("type",
                     "'" + key + "' is " + describeNode(*node) + ", expected an array of tables: write [[" +
                         key + "]] before each",
                     node->place);
    return tables;
  }
  if (node->elements.size() > kMaxEntries) {
    diagnostics_.add("value",
                     "there are " + std::to_string(node->elements.size()) + " of [[" + key +
                         "]], expected at most " + std::to_string(kMaxEntries),
                     node->place);
    return tables;
  }
  for (const TomlNode& element : node->elements) tables.push_back(&element);
  return tables;
}

void TableReader::finish() {
  for (const Entry& entry : table_.entries) {
    if (diagnostics_.full()) return;
    if (std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
    diagnostics_.add("unknown_key",
                     what_ + " has no key '" + entry.key + "'" + suggestNames(entry.key, known_),
                     entry.key_place);
  }
}

std::size_t TableReader::indexOfChoice(const std::string& key, const TomlNode& node,
                                       std::span<const std::string> names) {
  if (node.kind == NodeKind::kText) {
    const auto found = std::find(names.begin(), names.end(), node.text);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  }
  const std::string shown = node.kind == NodeKind::kText ? "'" + node.text + "'" : describeNode(node);
  diagnostics_.add(node.kind == NodeKind::kText ? "value" : "type",
                   "'" + key + "' of " + what_ + " is " + shown + suggestNames(node.text, names), node.place);
  return names.size();
}

}  // namespace reprise
