#include "compiler/source/embedded_sources.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <spirv/unified1/spirv.hpp11>

namespace reprise {
namespace {

using spv::Op;

constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kDebugSource = 35, kDebugSourceContinued = 102;  // of NonSemantic.Shader.DebugInfo.100

std::string textOf(std::span<const std::uint32_t> words) {
  const char* text = reinterpret_cast<const char*>(words.data());
  return {text, strnlen(text, words.size() * 4)};
}

// glslang says first how it was called, and then begins to count.
std::string withoutRemarks(const std::string& text) {
  constexpr const char* kBegin = "#line 1\n";
  const std::size_t begin = text.rfind("// OpModuleProcessed", 0) == 0 ? text.find(kBegin) : std::string::npos;
  return begin == std::string::npos ? text : text.substr(begin + std::strlen(kBegin));
}

// Sources are copied beside results, under the last part of their path.
bool namesFile(const std::string& path) {
  const std::string file = std::filesystem::path(path).filename().string();
  return !file.empty() && file != "." && file != "..";
}

class Reader {
 public:
  std::vector<SourceFile> run(std::span<const std::uint32_t> words) {
    for (std::size_t at = kHeaderWords; at < words.size(); at += words[at] >> 16) {
      const auto opcode = static_cast<Op>(words[at] & 0xffffu);
      if (opcode == Op::OpFunction) break;
      read(opcode, words.subspan(at + 1, (words[at] >> 16) - 1));
    }
    for (SourceFile& source : sources_) source.text = withoutRemarks(source.text);
    std::erase_if(sources_, [](const SourceFile& source) { return !namesFile(source.path) || source.text.empty(); });
    return std::move(sources_);
  }

 private:
  void read(Op opcode, std::span<const std::uint32_t> operands) {
    if (opcode == Op::OpString && operands.size() > 1) strings_[operands[0]] = textOf(operands.subspan(1));
    if (opcode == Op::OpExtInstImport && operands.size() > 1 && textOf(operands.subspan(1)) == "NonSemantic.Shader.DebugInfo.100") set_ = operands[0];
    if (opcode == Op::OpSource && operands.size() > 3) begin(strings_[operands[2]], textOf(operands.subspan(3)));
    if (opcode == Op::OpSourceContinued) goOn(textOf(operands));
    if (opcode != Op::OpExtInst || operands.size() < 5 || operands[2] != set_) return;
    if (operands[3] == kDebugSource && operands.size() > 5) begin(strings_[operands[4]], strings_[operands[5]]);
    if (operands[3] == kDebugSourceContinued) goOn(strings_[operands[4]]);
  }

  void begin(const std::string& path, const std::string& text) {
    const bool known = std::any_of(sources_.begin(), sources_.end(), [&](const SourceFile& source) { return source.path == path; });
    open_ = !known;
    if (!known) sources_.push_back({path, text});
  }

  void goOn(const std::string& text) {
    if (open_ && !sources_.empty()) sources_.back().text += text;
  }

  std::map<std::uint32_t, std::string> strings_;
  std::optional<std::uint32_t> set_;
  bool open_ = false;
  std::vector<SourceFile> sources_;
};

}  // namespace

std::vector<SourceFile> embeddedSources(std::span<const std::uint32_t> words) { return Reader().run(words); }

}  // namespace reprise
