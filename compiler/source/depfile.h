// Dependencies for make and ninja: "target: main include...", as -MD writes it.
//
// Spaces and '#' are escaped with a backslash, '$' is doubled, backslashes before a space are doubled, as GCC
// does; names with line breaks cannot be written in this syntax and are refused.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

// The text of the file, one dependency a line. Error: depfile.name (kInput) for a name with a line break.
Result<std::string> depfileText(const std::string& target, const std::vector<std::string>& dependencies);

// The same, written whole or not at all. Errors: as depfileText and writeFile.
Result<void> writeDepfile(const std::filesystem::path& file, const std::string& target,
                          const std::vector<std::string>& dependencies);

}  // namespace reprise
