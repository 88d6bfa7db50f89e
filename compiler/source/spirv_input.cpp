#include "compiler/source/spirv_input.h"

#include <algorithm>
#include <cstring>
#include <spirv/unified1/spirv.hpp11>
#include <utility>

#include "compiler/source/debug_instructions.h"
#include "compiler/source/embedded_sources.h"
#include "compiler/source/interface_names.h"
#include "compiler/source/module_limits.h"
#include "compiler/source/validate.h"

namespace reprise {
namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kSwappedMagic = 0x03022307;
constexpr auto kNewestLanguage = static_cast<std::uint32_t>(spv::SourceLanguage::HLSL);

std::uint32_t swapped(std::uint32_t word) {
  return (word >> 24) | ((word >> 8) & 0xff00u) | ((word << 8) & 0xff0000u) | (word << 24);
}

struct FoundEntry {
  std::string name;
  std::uint32_t function = 0;
  spv::ExecutionModel model = spv::ExecutionModel::Max;
};

std::string stageText(spv::ExecutionModel model) {
  switch (model) {
    case spv::ExecutionModel::Vertex:
      return "vertex";
    case spv::ExecutionModel::Fragment:
      return "fragment";
    case spv::ExecutionModel::TessellationControl:
      return "tessellation control";
    case spv::ExecutionModel::TessellationEvaluation:
      return "tessellation evaluation";
    case spv::ExecutionModel::Geometry:
      return "geometry";
    case spv::ExecutionModel::GLCompute:
      return "compute";
    case spv::ExecutionModel::Kernel:
      return "kernel";
    default:
      return "number " + std::to_string(static_cast<std::uint32_t>(model));
  }
}

std::string literalString(const std::vector<std::uint32_t>& words, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) {
    for (int byte = 0; byte < 4; ++byte) {
      const char c = static_cast<char>((words[i] >> (8 * byte)) & 0xffu);
      if (c == '\0') return text;
      text += c;
    }
  }
  return text;
}

// Walks the instructions. Truncated: the last one is cut off, or a function is left open.
Result<std::vector<FoundEntry>> walk(const std::vector<std::uint32_t>& words, const std::string& name) {
  std::vector<FoundEntry> entries;
  bool function_open = false;
  std::size_t at = kHeaderWords;
  while (at < words.size()) {
    const std::size_t length = words[at] >> 16;
    const auto opcode = static_cast<spv::Op>(words[at] & 0xffffu);
    if (length == 0) {
      return Error{
          ErrorKind::kInput,
          "source.invalid",
          "found an instruction of length 0 at word " + std::to_string(at) + "; the module is damaged",
          {name, 0, 0}};
    }
    if (length > words.size() - at) {
      return Error{ErrorKind::kInput,
                   "source.truncated",
                   "the module ends after " + std::to_string(words.size()) +
                       " words in the middle of an instruction that needs " + std::to_string(length) +
                       " words from " + std::to_string(at) + " on; give the whole file",
                   {name, 0, 0}};
    }
    if (opcode == spv::Op::OpFunction) function_open = true;
    if (opcode == spv::Op::OpFunctionEnd) function_open = false;
    if (opcode == spv::Op::OpEntryPoint && length > 3) {
      entries.push_back(
          {literalString(words, at + 3, at + length), words[at + 2], static_cast<spv::ExecutionModel>(words[at + 1])});
    }
    at += length;
  }
  if (function_open) {
    return Error{ErrorKind::kInput,
                 "source.truncated",
                 "the module ends after " + std::to_string(words.size()) +
                     " words within a function; give the whole file",
                 {name, 0, 0}};
  }
  return entries;
}

bool isStage(const FoundEntry& entry, ShaderStage stage) {
  return entry.model == (stage == ShaderStage::kVertex ? spv::ExecutionModel::Vertex : spv::ExecutionModel::Fragment);
}

// The entry point by its name; where nobody asked for a name and none is called main, the only one of the stage.
Result<FoundEntry> chooseEntry(const std::vector<FoundEntry>& entries, const std::string& file,
                               const CompileOptions& options) {
  std::string listed;
  std::optional<FoundEntry> found;
  for (const FoundEntry& entry : entries) {
    listed += (listed.empty() ? "\"" : ", \"") + entry.name + "\" (" + stageText(entry.model) + ")";
    if (entry.name != options.entry_point) continue;
    if (!found || (options.stage && isStage(entry, *options.stage))) found = entry;
  }
  if (!found && options.entry_point == CompileOptions{}.entry_point && options.stage) {
    const auto of_stage = [&](const FoundEntry& entry) { return isStage(entry, *options.stage); };
    if (std::count_if(entries.begin(), entries.end(), of_stage) == 1)
      found = *std::find_if(entries.begin(), entries.end(), of_stage);
  }
  if (!found) {
    return Error{ErrorKind::kInput,
                 "source.entry_point",
                 "the module has no entry point \"" + options.entry_point + "\"; it has " +
                     (listed.empty() ? "none" : listed),
                 {file, 0, 0}};
  }
  const std::string expected = options.stage ? nameOf(*options.stage) : "vertex or fragment";
  const std::string text = stageText(found->model);
  if (text != expected && (options.stage || (text != "vertex" && text != "fragment"))) {
    return Error{ErrorKind::kInput,
                 "source.stage",
                 "found a " + text + " shader; expected a " + expected + " shader",
                 {file, 0, 0}};
  }
  return *found;
}

// The module with this entry point alone, called main: what follows knows modules with one.
std::vector<std::uint32_t> withOnlyEntry(const std::vector<std::uint32_t>& words, const FoundEntry& entry) {
  constexpr std::uint32_t kMain[] = {0x6e69616du, 0};  // "main" and its end
  std::vector<std::uint32_t> result(words.begin(), words.begin() + kHeaderWords);
  for (std::size_t at = kHeaderWords; at < words.size(); at += words[at] >> 16) {
    const std::size_t end = at + (words[at] >> 16);
    const auto opcode = static_cast<spv::Op>(words[at] & 0xffffu);
    const bool is_entry = opcode == spv::Op::OpEntryPoint;
    const bool is_mode = opcode == spv::Op::OpExecutionMode || opcode == spv::Op::OpExecutionModeId;
    if ((is_entry && (words[at + 2] != entry.function || words[at + 1] != static_cast<std::uint32_t>(entry.model))) ||
        (is_mode && words[at + 1] != entry.function))
      continue;
    if (!is_entry) {
      result.insert(result.end(), words.begin() + static_cast<std::ptrdiff_t>(at), words.begin() + static_cast<std::ptrdiff_t>(end));
      continue;
    }
    const std::size_t interface = at + 3 + entry.name.size() / 4 + 1;
    result.push_back(static_cast<std::uint32_t>(5 + end - interface) << 16 | static_cast<std::uint32_t>(opcode));
    result.insert(result.end(), {words[at + 1], words[at + 2], kMain[0], kMain[1]});
    result.insert(result.end(), words.begin() + static_cast<std::ptrdiff_t>(interface), words.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return result;
}

// SPIRV-Tools rejects source languages that are younger than it, Slang's for one. They mean nothing to a module.
void forgetUnknownLanguages(std::vector<std::uint32_t>& words) {
  for (std::size_t at = kHeaderWords; at < words.size(); at += words[at] >> 16)
    if (static_cast<spv::Op>(words[at] & 0xffffu) == spv::Op::OpSource && words[at] >> 16 > 1 && words[at + 1] > kNewestLanguage)
      words[at + 1] = static_cast<std::uint32_t>(spv::SourceLanguage::Unknown);
}

}  // namespace

bool looksLikeSpirv(std::string_view bytes) {
  if (bytes.size() < 4) return false;
  std::uint32_t first = 0;
  std::memcpy(&first, bytes.data(), 4);
  return first == spv::MagicNumber || first == kSwappedMagic;
}

Result<CompiledShader> readSpirv(std::string_view bytes, const std::string& name,
                                 const CompileOptions& options) {
  if (bytes.size() % 4 != 0 || bytes.size() < kHeaderWords * 4) {
    return Error{ErrorKind::kInput,
                 "source.truncated",
                 "the module has " + std::to_string(bytes.size()) +
                     " bytes; expected a multiple of 4 and at least 20; give the whole file",
                 {name, 0, 0}};
  }
  CompiledShader shader;
  shader.main_path = name;
  shader.words.resize(bytes.size() / 4);
  std::memcpy(shader.words.data(), bytes.data(), bytes.size());
  if (shader.words.front() == kSwappedMagic) {
    for (std::uint32_t& word : shader.words) word = swapped(word);
  }
  REPRISE_ASSIGN(const std::vector<FoundEntry> entries, walk(shader.words, name));
  forgetUnknownLanguages(shader.words);
  shader.sources = embeddedSources(shader.words);
  shader.words = withoutDebugInstructions(shader.words);
  if (const Result<void> small = checkModuleLimits(shader.words); !small) {
    Error error = small.error();
    error.place.file = name;
    return error;
  }
  const Result<void> valid = validateModule(shader.words);
  if (!valid) {
    return Error{ErrorKind::kInput,
                 "source.invalid",
                 "the SPIR-V validator rejects the module: " + valid.error().message,
                 {name, 0, 0}};
  }
  REPRISE_ASSIGN(const FoundEntry entry, chooseEntry(entries, name, options));
  shader.stage = entry.model == spv::ExecutionModel::Vertex ? ShaderStage::kVertex : ShaderStage::kFragment;
  if (entries.size() > 1 || entry.name != "main") shader.words = withOnlyEntry(shader.words, entry);
  shader.words = withInterfaceNames(shader.words);
  return shader;
}

}  // namespace reprise
