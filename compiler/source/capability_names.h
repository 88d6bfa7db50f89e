// The capabilities that a SPIR-V module declares, by name.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace reprise {

// In the module's order: "Shader", "ImageQuery", "DemoteToHelperInvocation"; without the suffix of an extension's author.
std::vector<std::string> capabilityNames(std::span<const std::uint32_t> words);

}  // namespace reprise
