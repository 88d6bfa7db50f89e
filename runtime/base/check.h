// Assertions for faults of Reprise itself. They stay on in release builds, print the values involved and end the
// program with exit status 70 (EX_SOFTWARE), as the command line promises.
#pragma once

#include <sstream>
#include <string>

namespace reprise {

[[noreturn]] void failCheck(const char* condition, const char* file, int line, const std::string& values);

template <typename... Values>
std::string describeValues(const Values&... values) {
  std::ostringstream stream;
  const char* separator = "";
  ((stream << separator << values, separator = ", "), ...);
  return stream.str();
}

}  // namespace reprise

// REPRISE_CHECK(index < size, index, size) prints "check failed: index < size [7, 5]".
#define REPRISE_CHECK(condition, ...)                                                                     \
  do {                                                                                                    \
    if (!(condition)) [[unlikely]]                                                                        \
      ::reprise::failCheck(#condition, __FILE__, __LINE__, ::reprise::describeValues(__VA_ARGS__));       \
  } while (false)
