#include "compiler/source/spirv_input.h"

#include <cstring>
#include <spirv/unified1/spirv.hpp11>
#include <utility>

#include "compiler/source/validate.h"

namespace reprise {
namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kSwappedMagic = 0x03022307;

std::uint32_t swapped(std::uint32_t word) {
  return (word >> 24) | ((word >> 8) & 0xff00u) | ((word << 8) & 0xff0000u) | (word << 24);
}

struct FoundEntry {
  std::string name;
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
          {literalString(words, at + 3, at + length), static_cast<spv::ExecutionModel>(words[at + 1])});
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

Result<ShaderStage> chooseStage(const std::vector<FoundEntry>& entries, const std::string& file,
                                const CompileOptions& options) {
  std::string listed;
  std::optional<spv::ExecutionModel> found;
  for (const FoundEntry& entry : entries) {
    listed += (listed.empty() ? "\"" : ", \"") + entry.name + "\" (" + stageText(entry.model) + ")";
    if (entry.name != options.entry_point) continue;
    const bool wanted =
        (entry.model == spv::ExecutionModel::Vertex && options.stage == ShaderStage::kVertex) ||
        (entry.model == spv::ExecutionModel::Fragment && options.stage == ShaderStage::kFragment);
    if (!found || wanted) found = entry.model;
  }
  if (!found) {
    return Error{ErrorKind::kInput,
                 "source.entry_point",
                 "the module has no entry point \"" + options.entry_point + "\"; it has " +
                     (listed.empty() ? "none" : listed),
                 {file, 0, 0}};
  }
  const std::string expected = options.stage ? nameOf(*options.stage) : "vertex or fragment";
  const std::string text = stageText(*found);
  if (text != expected && (options.stage || (text != "vertex" && text != "fragment"))) {
    return Error{ErrorKind::kInput,
                 "source.stage",
                 "found a " + text + " shader; expected a " + expected + " shader",
                 {file, 0, 0}};
  }
  return *found == spv::ExecutionModel::Vertex ? ShaderStage::kVertex : ShaderStage::kFragment;
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
  const Result<void> valid = validateModule(shader.words);
  if (!valid) {
    return Error{ErrorKind::kInput,
                 "source.invalid",
                 "the SPIR-V validator rejects the module: " + valid.error().message,
                 {name, 0, 0}};
  }
  REPRISE_ASSIGN(shader.stage, chooseStage(entries, name, options));
  return shader;
}

}  // namespace reprise
