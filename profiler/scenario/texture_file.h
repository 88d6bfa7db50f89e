// The bytes of a texture's file.
#pragma once

#include <string>

#include "profiler/scenario/scenario.h"
#include "runtime/base/result.h"

namespace reprise {

// spec is of kFile. Errors, where the scenario names the file: texture.missing, else those of readFile, of kMostImageBytes.
Result<std::string> readTextureFile(const TextureSpec& spec);

}  // namespace reprise
