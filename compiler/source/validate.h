// SPIR-V through SPIRV-Tools: validator, disassembler, assembler.
//
// The environment follows the version in the module's header: Vulkan 1.1 up to SPIR-V 1.3, Vulkan 1.1 with
// SPIR-V 1.4, Vulkan 1.2 for 1.5, Vulkan 1.3 for 1.6.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

// What spirv-val says of a module. Error: spirv.invalid (kInput) with the validator's message. Callers for
// whom an invalid module is their own fault turn it into a REPRISE_CHECK. Never crashes, whatever the words
// are.
Result<void> validateModule(std::span<const std::uint32_t> words);

// Assembler text with friendly names and indentation. Words that are no SPIR-V give a comment line that says
// so.
std::string disassemble(std::span<const std::uint32_t> words);

// Assembler text to words: of the version that the disassembler's header comment names, else SPIR-V 1.3. Not
// validated. assemble(disassemble(m)) has the instructions of m in their order; ids are numbered anew. Error:
// spirv.assembly (kInput) with line and column.
Result<std::vector<std::uint32_t>> assemble(std::string_view text);

}  // namespace reprise
