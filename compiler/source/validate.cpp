#include "compiler/source/validate.h"

#include <spirv-tools/libspirv.hpp>

namespace reprise {
namespace {

// The validator makes names unique by counting up from 1 for each.
constexpr std::size_t kMostFriendlyNames = 1000;

std::size_t countNames(std::span<const std::uint32_t> words) {
  constexpr std::uint32_t kName = 5;
  std::size_t names = 0;
  for (std::size_t at = 5; at < words.size() && words[at] >> 16 != 0; at += words[at] >> 16) names += (words[at] & 0xffffu) == kName;
  return names;
}

constexpr std::uint32_t kVersion13 = 0x00010300, kVersion14 = 0x00010400, kVersion15 = 0x00010500;

spv_target_env environmentOf(std::uint32_t version) {
  if (version <= kVersion13) return SPV_ENV_VULKAN_1_1;
  if (version <= kVersion14) return SPV_ENV_VULKAN_1_1_SPIRV_1_4;
  if (version <= kVersion15) return SPV_ENV_VULKAN_1_2;
  return SPV_ENV_VULKAN_1_3;
}

// The disassembler begins its text with "; SPIR-V" and "; Version: 1.N".
spv_target_env assemblyEnvironment(std::string_view text) {
  constexpr std::string_view kMarker = "; Version: 1.";
  const std::size_t at = text.find(kMarker);
  if (at == std::string_view::npos || at + kMarker.size() >= text.size()) return SPV_ENV_UNIVERSAL_1_3;
  switch (text[at + kMarker.size()]) {
    case '0':
      return SPV_ENV_UNIVERSAL_1_0;
    case '1':
      return SPV_ENV_UNIVERSAL_1_1;
    case '2':
      return SPV_ENV_UNIVERSAL_1_2;
    case '4':
      return SPV_ENV_UNIVERSAL_1_4;
    case '5':
      return SPV_ENV_UNIVERSAL_1_5;
    case '6':
      return SPV_ENV_UNIVERSAL_1_6;
    default:
      return SPV_ENV_UNIVERSAL_1_3;
  }
}

}  // namespace

Result<void> validateModule(std::span<const std::uint32_t> words) {
  spvtools::SpirvTools tools(environmentOf(words.size() > 1 ? words[1] : kVersion13));
  std::string first_message;
  tools.SetMessageConsumer(
      [&](spv_message_level_t level, const char*, const spv_position_t&, const char* text) {
        if (level <= SPV_MSG_ERROR && first_message.empty()) first_message = text;
      });
  spvtools::ValidatorOptions options;
  options.SetFriendlyNames(countNames(words) <= kMostFriendlyNames);
  if (tools.Validate(words.data(), words.size(), options)) return {};
  return Error{ErrorKind::kInput,
               "spirv.invalid",
               first_message.empty() ? "the module is no valid SPIR-V for Vulkan" : first_message,
               {}};
}

std::string disassemble(std::span<const std::uint32_t> words) {
  const spvtools::SpirvTools tools(SPV_ENV_UNIVERSAL_1_6);
  std::string text;
  const std::uint32_t options = SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES | SPV_BINARY_TO_TEXT_OPTION_INDENT;
  if (tools.IsValid() && tools.Disassemble(words.data(), words.size(), &text, options)) return text;
  return "; not a SPIR-V module (" + std::to_string(words.size()) + " words)\n";
}

Result<std::vector<std::uint32_t>> assemble(std::string_view text) {
  spvtools::SpirvTools tools(assemblyEnvironment(text));
  Error error{ErrorKind::kInput, "spirv.assembly", "the text does not assemble", {}};
  bool told = false;
  tools.SetMessageConsumer(
      [&](spv_message_level_t level, const char*, const spv_position_t& position, const char* message) {
        if (level > SPV_MSG_ERROR || told) return;
        told = true;
        error.message = message;
        error.place.line = static_cast<int>(position.line) + 1;
        error.place.column = static_cast<int>(position.column) + 1;
      });
  std::vector<std::uint32_t> words;
  if (!tools.Assemble(text.data(), text.size(), &words)) return error;
  return words;
}

}  // namespace reprise
