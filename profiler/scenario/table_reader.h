// Reads the keys of one TOML table into plain values. What does not fit is added to the diagnostics and
// leaves the value as it was, so that reading goes on and finds the other mistakes, too.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "profiler/scenario/diagnostics.h"
#include "profiler/scenario/document.h"
#include "profiler/scenario/names.h"

namespace reprise {

struct Range {
  double low, high;
  bool low_open = false;  // low itself is too small
};
inline constexpr Range kAnyNumber = {-1e9, 1e9};
inline constexpr Range kPositive = {0, 1e9, true};
inline constexpr Range kNotNegative = {0, 1e9};

enum class Need { kOptional, kRequired };

class TableReader {
 public:
  // `what` names the table in messages: "[render]", "object 'knot'". A node that is no table is reported, and
  // then every key is absent.
  TableReader(const TomlNode& table, std::string what, Diagnostics& diagnostics);

  // The value of a key, or null; from then on the key is known.
  const TomlNode* find(const std::string& key, Need need = Need::kOptional);
  bool has(const std::string& key) const;
  const TomlNode& table() const { return table_; }
  const std::string& what() const { return what_; }
  Diagnostics& diagnostics() { return diagnostics_; }

  void readText(const std::string& key, std::string& value, Need need = Need::kOptional);
  void readBoolean(const std::string& key, bool& value);
  void readNumber(const std::string& key, float& value, Range range = kAnyNumber);
  void readNumbers(const std::string& key, std::span<float> value,
                   Range range = kAnyNumber);  // an array of that size
  void readInteger(const std::string& key, int& value, Range range);
  void readUnsigned(const std::string& key, std::uint32_t& value,
                    Range range = {0, std::numeric_limits<std::uint32_t>::max()});
  template <typename T, std::size_t N>
  void readChoice(const std::string& key, T& value, const NameWithValue<T> (&choices)[N]);

  // The tables of an array of tables ([[object]]); empty where it is absent.
  std::vector<const TomlNode*> findTables(const std::string& key);

  // Reports the keys that nobody asked for.
  void finish();

 private:
  std::size_t indexOfChoice(const std::string& key, const TomlNode& node, std::span<const std::string> names);

  const TomlNode& table_;
  std::string what_;
  Diagnostics& diagnostics_;
  std::vector<std::string> known_;
};

// A finite number in range, as float; false and a diagnostic where it is none. `what` names it in the
// message.
bool numberOf(const TomlNode& node, const std::string& what, Range range, float& value, Diagnostics& diagnostics);

template <typename T, std::size_t N>
void TableReader::readChoice(const std::string& key, T& value, const NameWithValue<T> (&choices)[N]) {
  const TomlNode* node = find(key);
  if (!node) return;
  std::vector<std::string> names;
  for (const NameWithValue<T>& choice : choices) names.emplace_back(choice.name);
  const std::size_t index = indexOfChoice(key, *node, names);
  if (index < N) value = choices[index].value;
}

}  // namespace reprise
