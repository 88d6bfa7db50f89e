// Errors with places out of the text that glslang logs.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "compiler/source/compile.h"

namespace reprise {

// The first error of the log that has a place (the first of all where none has) as source.syntax; the others
// are its others, each at its own place. The column is that of the reported token's first
// occurrence in its line of `sources`, 0 where it is not found there. main_path stands for the file where the
// log names none.
Error errorOfLog(std::string_view log, const std::string& main_path, std::span<const SourceFile> sources);

}  // namespace reprise
