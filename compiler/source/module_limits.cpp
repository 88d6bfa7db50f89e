#include "compiler/source/module_limits.h"

#include <algorithm>
#include <spirv/unified1/spirv.hpp11>
#include <string>
#include <unordered_map>
#include <vector>

namespace reprise {
namespace {

using spv::Op;

constexpr std::size_t kHeaderWords = 5, kBoundWord = 3;
constexpr std::uint32_t kMostSplitElements = 100;  // longer arrays are not taken apart (optimize.cpp)

std::uint64_t sum(std::uint64_t a, std::uint64_t b) { return std::min(a + b, kMostTypeParts + 1); }
std::uint64_t product(std::uint64_t a, std::uint64_t b) { return a > kMostTypeParts || b > kMostTypeParts ? kMostTypeParts + 1 : sum(a * b, 0); }

struct OpenConstruct {
  std::uint32_t merge = 0, next = 0;  // labels; next: where a loop continues
  std::size_t first_awaited = 0;
};

class Walk {
 public:
  explicit Walk(std::span<const std::uint32_t> words) : words_(words), bound_(words[kBoundWord]) {}

  Result<void> run() {
    REPRISE_TRY(allow("ids", bound_, kMaxIds));
    parts_.assign(bound_, {});
    constants_.assign(bound_, 0);
    group_.assign(bound_, 0);
    labels_.assign(bound_, {});
    for (at_ = kHeaderWords; at_ < words_.size(); at_ += length_) {
      length_ = words_[at_] >> 16;
      if (length_ == 0 || length_ > words_.size() - at_) break;
      visit(static_cast<Op>(words_[at_] & 0xffffu));
      REPRISE_TRY(allow("levels of nested loops and selections", stuck_ + open_.size(), kMostNesting));
    }
    REPRISE_TRY(allow("functions", functions_.size(), kMostFunctions));
    REPRISE_TRY(allow("entry points", entry_points_.size(), kMostEntryPoints));
    REPRISE_TRY(allow("blocks", blocks_, kMostBlocks));
    REPRISE_TRY(allow("loops", loops_, kMostLoops));
    REPRISE_TRY(allow("selections", selections_, kMostSelections));
    REPRISE_TRY(allow("parts in one type", largest_type_, kMostPartsOfType));
    REPRISE_TRY(allow("parts of types, over all their uses,", used_parts_, kMostTypeParts));
    REPRISE_TRY(allow("decorations by groups", group_decorations_, kMostGroupDecorations));
    for (const std::uint32_t entry : entry_points_)
      REPRISE_TRY(allow("instructions, all calls inlined, or calls deeper than " + std::to_string(kMostCallDepth) + ",",
                        inlinedLength(entry, 0), kMostInlinedInstructions));
    return {};
  }

 private:
  struct Label {
    bool seen = false, awaited = false;
    std::uint16_t opened = 0;  // open constructs that go on here
  };

  struct Parts {
    std::uint64_t whole = 0, split = 0;  // arrays counted once, arrays counted by elements
  };

  struct Function {
    std::size_t length = 0;
    std::vector<std::uint32_t> callees;
    std::size_t inlined = 0;  // length with calls inlined; 0: not known yet
  };

  // Each function is looked into once. Too long where calls go too deep or are recursive, which the validator forbids.
  std::size_t inlinedLength(std::uint32_t id, int depth) {
    constexpr std::size_t kTooLong = kMostInlinedInstructions + 1;
    const auto found = function_of_.find(id);
    if (found == function_of_.end()) return 0;
    Function& function = functions_[found->second];
    if (function.inlined > 0) return function.inlined;
    if (depth > kMostCallDepth) return kTooLong;
    function.inlined = kTooLong;
    std::size_t length = std::max<std::size_t>(function.length, 1);
    for (const std::uint32_t callee : function.callees) length = std::min(length + inlinedLength(callee, depth + 1), kTooLong);
    return function.inlined = std::min(length, kTooLong);
  }

  static Result<void> allow(const std::string& what, std::uint64_t found, std::uint64_t most) {
    if (found <= most) return {};
    return Error{ErrorKind::kInput, "spirv.limit",
                 "the module has " + std::to_string(found) + " or more " + what + "; at most " + std::to_string(most) + " are taken", {}};
  }

  // 0, which no id is, where there is no such operand or it is no id of the module.
  std::uint32_t id(std::size_t operand) const {
    const std::uint32_t word = operand + 1 < length_ ? words_[at_ + 1 + operand] : 0;
    return word < bound_ ? word : 0;
  }

  void visit(Op opcode) {
    if (!functions_.empty()) ++functions_.back().length;
    switch (opcode) {
      case Op::OpEntryPoint: entry_points_.push_back(id(1)); break;
      case Op::OpFunction: beginFunction(id(1)); break;
      case Op::OpFunctionCall:
        if (!functions_.empty()) functions_.back().callees.push_back(id(2));
        visitType(opcode);
        break;
      case Op::OpLabel: beginBlock(id(0)); break;
      case Op::OpLoopMerge: ++loops_, open({id(0), id(1), awaited_.size()}); break;
      case Op::OpSelectionMerge: ++selections_, open({id(0), 0, awaited_.size()}); break;
      case Op::OpBranch: await(id(0)); break;
      case Op::OpBranchConditional: await(id(1)), await(id(2)); break;
      case Op::OpSwitch:
        // Literals among the targets are taken for labels, too: that can but make the nesting deeper.
        for (std::size_t i = 1; i + 1 < length_; ++i) await(id(i));
        break;
      case Op::OpDecorate:
      case Op::OpDecorateId: ++group_[id(0)]; break;
      case Op::OpGroupDecorate:
      case Op::OpGroupMemberDecorate: group_decorations_ += std::uint64_t{group_[id(0)]} * (length_ - 1); break;
      default: visitType(opcode);
    }
  }

  void visitType(Op opcode) {
    Parts parts{1, 1};
    switch (opcode) {
      case Op::OpTypeStruct:
        for (std::size_t i = 1; i + 1 < length_; ++i) {
          parts.whole = sum(parts.whole, partsOf(id(i)).whole);
          parts.split = sum(parts.split, partsOf(id(i)).split);
        }
        break;
      case Op::OpTypeArray:
        parts = {sum(1, partsOf(id(1)).whole), sum(1, product(partsOf(id(1)).split, elementsOf(id(2))))};
        break;
      case Op::OpTypeRuntimeArray:
      case Op::OpTypeMatrix: parts = {sum(1, partsOf(id(1)).whole), sum(1, partsOf(id(1)).split)}; break;
      case Op::OpTypePointer: {
        const Parts pointee = partsOf(id(2));
        const bool local = length_ > 2 && words_[at_ + 2] == static_cast<std::uint32_t>(spv::StorageClass::Function);
        parts_[id(0)].whole = local ? pointee.split : pointee.whole;
        return;
      }
      case Op::OpConstant:
        if (length_ > 3) constants_[id(1)] = words_[at_ + 3];
        return;
      default:
        // Of what is no type the first operand is the result's type, if it is one at all.
        if (parts_[id(0)].whole > 1) used_parts_ = sum(used_parts_, parts_[id(0)].whole);
        return;
    }
    parts_[id(0)] = parts;
    largest_type_ = std::max(largest_type_, parts.whole);
    used_parts_ = sum(used_parts_, parts.whole);
  }

  Parts partsOf(std::uint32_t type) const { return {std::max<std::uint64_t>(parts_[type].whole, 1), std::max<std::uint64_t>(parts_[type].split, 1)}; }

  // A length that is no constant is taken for long.
  std::uint32_t elementsOf(std::uint32_t length) const {
    return constants_[length] == 0 ? kMostSplitElements : std::min(constants_[length], kMostSplitElements);
  }

  void beginFunction(std::uint32_t function) {
    function_of_[function] = functions_.size();
    functions_.emplace_back();
    for (const OpenConstruct& construct : open_) close(construct);
    open_.clear();
    awaited_.clear();
    stuck_ = 0;
  }

  void open(const OpenConstruct& construct) {
    ++labels_[construct.merge].opened;
    ++labels_[construct.next].opened;
    open_.push_back(construct);
  }

  void close(const OpenConstruct& construct) {
    --labels_[construct.merge].opened;
    --labels_[construct.next].opened;
  }

  void await(std::uint32_t label) {
    if (labels_[label].seen || labels_[label].awaited) return;
    labels_[label].awaited = true;
    awaited_.push_back(label);
  }

  // A construct ends with the block that it merges into if by then all of its blocks have been seen: what its branches
  // still await belongs to constructs around it. Else its level stays taken until the function ends.
  void beginBlock(std::uint32_t label) {
    ++blocks_;
    labels_[label].seen = true;
    while (!open_.empty() && open_.back().merge == label) {
      const OpenConstruct construct = open_.back();
      open_.pop_back();
      close(construct);
      const auto first = awaited_.begin() + static_cast<std::ptrdiff_t>(std::min(construct.first_awaited, awaited_.size()));
      awaited_.erase(std::remove_if(first, awaited_.end(), [&](std::uint32_t one) { return labels_[one].seen; }), awaited_.end());
      if (std::any_of(first, awaited_.end(), [&](std::uint32_t one) { return labels_[one].opened == 0; })) ++stuck_;
    }
  }

  std::span<const std::uint32_t> words_;
  std::uint32_t bound_ = 0;
  std::size_t at_ = 0, length_ = 0;
  std::vector<Parts> parts_;          // of types, by id; of pointers `whole` alone
  std::vector<std::uint32_t> group_;  // decorations, by id
  std::vector<Label> labels_;
  std::vector<std::uint32_t> constants_;  // first word of the value, by id
  std::vector<OpenConstruct> open_;
  std::vector<std::uint32_t> awaited_;
  std::size_t stuck_ = 0;
  std::vector<Function> functions_;
  std::unordered_map<std::uint32_t, std::size_t> function_of_;  // by id: index
  std::vector<std::uint32_t> entry_points_;                     // functions
  std::size_t blocks_ = 0, loops_ = 0, selections_ = 0;
  std::uint64_t largest_type_ = 0, used_parts_ = 0, group_decorations_ = 0;
};

}  // namespace

Result<void> checkModuleLimits(std::span<const std::uint32_t> words) {
  if (words.size() < kHeaderWords || words[0] != spv::MagicNumber || words[kBoundWord] == 0) return {};
  return Walk(words).run();
}

}  // namespace reprise
