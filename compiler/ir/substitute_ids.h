// Values in place of others.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "compiler/ir/module.h"

namespace reprise {

// Every use of a key in the function becomes one of what stands for it, also through several steps. The map must have no cycle.
void substituteIds(Function& function, std::unordered_map<std::uint32_t, std::uint32_t> replacements);

}  // namespace reprise
