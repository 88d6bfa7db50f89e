// JSON values read strictly, for the .cpp files of this folder: a value of another type or out of range throws
// std::invalid_argument. A manifest is written by tools, so anything else is damage.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace reprise {

inline constexpr int kMostJsonDepth = 64;
inline constexpr std::size_t kMostJsonEntries = 4096;

// Spellings of an enumeration.
template <typename Enum>
using EnumNames = std::vector<std::pair<Enum, const char*>>;

template <typename Enum>
std::string enumText(const EnumNames<Enum>& names, Enum value) {
  for (const auto& [entry, name] : names)
    if (entry == value) return name;
  throw std::invalid_argument("a value has no name");
}

// Nested values go on the stack where they are written again, so their depth is bounded.
inline nlohmann::json parseJson(const std::string& text) {
  return nlohmann::json::parse(text, [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    if (depth > kMostJsonDepth) throw std::invalid_argument("the values are nested too deeply");
    return true;
  });
}

// Text in which bytes that are no UTF-8 are replaced: names come from SPIR-V, which promises nothing.
inline std::string jsonText(const nlohmann::json& value, int indent = -1) {
  return value.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

// JSON has no infinity and no NaN; they are written as strings.
inline nlohmann::json floatJson(float value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

inline nlohmann::json floatsJson(std::span<const float> values) {
  nlohmann::json list = nlohmann::json::array();
  for (const float value : values) list.push_back(floatJson(value));
  return list;
}

[[noreturn]] inline void failValue(const char* key, const char* expected) {
  throw std::invalid_argument(std::string("'") + key + "' must be " + expected);
}

inline float floatFrom(const nlohmann::json& value, const char* key) {
  if (value.is_number()) return value.get<float>();
  if (value == "inf") return std::numeric_limits<float>::infinity();
  if (value == "-inf") return -std::numeric_limits<float>::infinity();
  if (value == "nan") return std::numeric_limits<float>::quiet_NaN();
  failValue(key, "a number");
}

template <std::size_t kCount = 4>
std::array<float, kCount> floatsAt(const nlohmann::json& from, const char* key) {
  const nlohmann::json& list = from.at(key);
  if (!list.is_array() || list.size() != kCount) failValue(key, kCount == 4 ? "four numbers" : "sixteen numbers");
  std::array<float, kCount> values;
  for (std::size_t i = 0; i < kCount; ++i) values[i] = floatFrom(list[i], key);
  return values;
}

inline std::string textAt(const nlohmann::json& from, const char* key) {
  const nlohmann::json& value = from.at(key);
  if (!value.is_string()) failValue(key, "a text");
  return value.get<std::string>();
}

inline bool boolAt(const nlohmann::json& from, const char* key) {
  const nlohmann::json& value = from.at(key);
  if (!value.is_boolean()) failValue(key, "true or false");
  return value.get<bool>();
}

template <std::integral T>
T integerFrom(const nlohmann::json& value, const char* key) {
  if (value.is_number_unsigned() && std::in_range<T>(value.get<std::uint64_t>())) return value.get<T>();
  if (value.is_number_integer() && !value.is_number_unsigned() && std::in_range<T>(value.get<std::int64_t>()))
    return value.get<T>();
  failValue(key, "a whole number in range");
}

template <std::integral T>
T integerAt(const nlohmann::json& from, const char* key) {
  return integerFrom<T>(from.at(key), key);
}

template <typename Enum>
Enum enumAt(const nlohmann::json& from, const char* key, const EnumNames<Enum>& names) {
  const std::string text = textAt(from, key);
  for (const auto& [value, name] : names)
    if (text == name) return value;
  throw std::invalid_argument("'" + text + "' is no value of '" + key + "'");
}

template <typename T, typename Convert>
nlohmann::json listJson(const std::vector<T>& values, Convert convert) {
  nlohmann::json list = nlohmann::json::array();
  for (const T& value : values) list.push_back(convert(value));
  return list;
}

template <typename T, typename Convert>
std::vector<T> listAt(const nlohmann::json& from, const char* key, Convert convert) {
  const nlohmann::json& list = from.at(key);
  if (!list.is_array() || list.size() > kMostJsonEntries) failValue(key, "a list of at most 4096 entries");
  std::vector<T> values;
  for (const nlohmann::json& entry : list) values.push_back(convert(entry));
  return values;
}

}  // namespace reprise
