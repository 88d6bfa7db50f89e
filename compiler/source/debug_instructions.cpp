#include "compiler/source/debug_instructions.h"

#include <cstring>
#include <spirv/unified1/spirv.hpp11>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace reprise {
namespace {

using spv::Op;

constexpr std::size_t kHeaderWords = 5;
constexpr const char* kLineSet = "NonSemantic.Shader.DebugInfo.100";
// Of that set, by its specification.
constexpr std::uint32_t kDebugSource = 35, kDebugLine = 103, kDebugNoLine = 104;

using Words = std::span<const std::uint32_t>;

std::string textOf(Words words) {
  const char* text = reinterpret_cast<const char*>(words.data());
  return {text, strnlen(text, words.size() * 4)};
}

bool isDebugSet(const std::string& name) {
  return name.rfind("NonSemantic.", 0) == 0 || name == "OpenCL.DebugInfo.100" || name == "DebugInfo";
}

class Stripper {
 public:
  explicit Stripper(Words words) : words_(words) {}

  std::vector<std::uint32_t> run() {
    forEach([this](Op opcode, Words operands) { collect(opcode, operands); });
    if (sets_.empty()) return {words_.begin(), words_.end()};
    result_.assign(words_.begin(), words_.begin() + kHeaderWords);
    forEach([this](Op opcode, Words operands) {
      if (drops(opcode, operands)) return;
      placeLine(opcode);
      result_.insert(result_.end(), operands.data() - 1, operands.data() + operands.size());
    });
    return std::move(result_);
  }

 private:
  template <typename Visit>
  void forEach(const Visit& visit) {
    for (std::size_t at = kHeaderWords; at < words_.size(); at += words_[at] >> 16)
      visit(static_cast<Op>(words_[at] & 0xffffu), words_.subspan(at + 1, (words_[at] >> 16) - 1));
  }

  // Operands of OpExtInst: type, result, set, number.
  bool isOfSet(Op opcode, Words operands) const { return opcode == Op::OpExtInst && operands.size() >= 4 && sets_.count(operands[2]) != 0; }

  void collect(Op opcode, Words operands) {
    if (opcode == Op::OpExtInstImport && operands.size() > 1 && isDebugSet(textOf(operands.subspan(1))))
      sets_[operands[0]] = textOf(operands.subspan(1)) == kLineSet;
    if (opcode == Op::OpConstant && operands.size() == 3) constants_[operands[1]] = operands[2];
    if (!isOfSet(opcode, operands)) return;
    dropped_.insert(operands[1]);
    if (sets_[operands[2]] && operands[3] == kDebugSource && operands.size() > 4) files_[operands[1]] = operands[4];
  }

  bool drops(Op opcode, Words operands) {
    if (opcode == Op::OpExtension) return textOf(operands) == "SPV_KHR_non_semantic_info";
    if (opcode == Op::OpExtInstImport) return !operands.empty() && sets_.count(operands[0]) != 0;
    if (opcode == Op::OpName || opcode == Op::OpDecorate) return !operands.empty() && dropped_.count(operands[0]) != 0;
    if (!isOfSet(opcode, operands)) return false;
    if (sets_[operands[2]]) readLine(operands);
    return true;
  }

  void readLine(Words operands) {
    if (operands[3] == kDebugNoLine) line_ = {kNoLineWord};
    if (operands[3] != kDebugLine || operands.size() < 6) return;
    const auto file = files_.find(operands[4]);
    const std::uint32_t row = constant(operands[5]), column = operands.size() > 7 ? constant(operands[7]) : 0;
    if (file == files_.end() || row == 0) {
      line_ = {kNoLineWord};
    } else {
      line_ = {4u << 16 | static_cast<std::uint32_t>(Op::OpLine), file->second, row, column};
    }
  }

  // Not where no line may stand: behind a terminator.
  void placeLine(Op next) {
    if (line_.empty()) return;
    if (next != Op::OpLabel && next != Op::OpFunctionEnd && next != Op::OpFunction) result_.insert(result_.end(), line_.begin(), line_.end());
    line_.clear();
  }

  std::uint32_t constant(std::uint32_t id) const {
    const auto found = constants_.find(id);
    return found == constants_.end() ? 0 : found->second;
  }

  static constexpr std::uint32_t kNoLineWord = 1u << 16 | static_cast<std::uint32_t>(Op::OpNoLine);

  Words words_;
  std::unordered_map<std::uint32_t, bool> sets_;                // by id of the import: whether its lines are known
  std::unordered_map<std::uint32_t, std::uint32_t> files_;      // by id of a DebugSource: the OpString of its path
  std::unordered_map<std::uint32_t, std::uint32_t> constants_;  // of one word, by id
  std::unordered_set<std::uint32_t> dropped_;                   // results
  std::vector<std::uint32_t> line_;                             // to be placed before the next instruction
  std::vector<std::uint32_t> result_;
};

}  // namespace

std::vector<std::uint32_t> withoutDebugInstructions(std::span<const std::uint32_t> words) { return Stripper(words).run(); }

}  // namespace reprise
