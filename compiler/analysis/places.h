// Where the values of a shader come from, for many values at once.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/ir/prepare.h"
#include "compiler/source/compile.h"
#include "runtime/base/result.h"

namespace reprise {

// The shader and the sources must outlive it.
class PlaceFinder {
 public:
  PlaceFinder(const PreparedShader& shader, const std::vector<SourceFile>& sources);
  // What placeOf of analyse.h says.
  Place placeOf(const Instruction& instruction) const;

 private:
  const PreparedShader& shader_;
  std::unordered_map<std::uint32_t, std::string> files_;                          // by id of the OpString
  std::unordered_map<std::string, std::vector<std::string_view>> lines_of_file_;  // of sources
};

}  // namespace reprise
