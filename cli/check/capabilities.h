// Whether a device can run a module at all: its SPIR-V capabilities against the device's features.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "runtime/vulkan/context.h"

namespace reprise {

// The name of the first capability that the device lacks, or that no device of version 1 is known to have; "" if there is none.
std::string missingCapability(std::span<const std::uint32_t> words, const Context& context);

}  // namespace reprise
