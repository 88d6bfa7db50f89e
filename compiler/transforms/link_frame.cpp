#include "compiler/transforms/link_frame.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "compiler/ir/globals.h"

namespace reprise {
namespace {

using spv::Op;
using spv::StorageClass;

// glslang's function names carry a signature: "main_body(" for void main_body().
std::string plainName(const std::string& name) { return name.substr(0, name.find('(')); }

bool isUniqueType(Op opcode) {
  switch (opcode) {
    case Op::OpTypeVoid:
    case Op::OpTypeBool:
    case Op::OpTypeInt:
    case Op::OpTypeFloat:
    case Op::OpTypeVector:
    case Op::OpTypeMatrix:
    case Op::OpTypeImage:
    case Op::OpTypeSampler:
    case Op::OpTypeSampledImage:
    case Op::OpTypePointer:
    case Op::OpTypeFunction: return true;
    default: return false;
  }
}

class Linker {
 public:
  Linker(const Module& host, const Module& frame, const FrameBindings& bindings)
      : module_(host), frame_(frame), bindings_(bindings) {
    for (const Instruction& name : frame.names)
      if (name.opcode == Op::OpName) frame_names_[name.word(0)] = plainName(stringOf(name.operands[1]));
  }

  Module run() {
    unite(module_.capabilities, frame_.capabilities);
    unite(module_.extensions, frame_.extensions);
    importSets();
    for (const Function& function : frame_.functions) {
      const auto body = bindings_.functions.find(frame_names_[function.id()]);
      if (body != bindings_.functions.end()) ids_[function.id()] = body->second;
    }
    importGlobals();
    importAbout(frame_.names, module_.names);
    importAbout(frame_.annotations, module_.annotations);
    for (const Function& function : frame_.functions)
      if (bindings_.functions.count(frame_names_[function.id()]) == 0) importFunction(function);
    replaceEntryPoints();
    takeOverVariables();
    dropUnusedInterface();
    if (module_.version >= 0x00010400) listAllGlobals();
    if (module_.version < 0x00010300) declareStorageClass();
    return std::move(module_);
  }

 private:
  static void unite(std::vector<Instruction>& to, const std::vector<Instruction>& from) {
    for (const Instruction& instruction : from)
      if (std::find(to.begin(), to.end(), instruction) == to.end()) to.push_back(instruction);
  }

  std::uint32_t translate(std::uint32_t id) {
    if (id == 0) return 0;
    const auto found = ids_.find(id);
    if (found != ids_.end()) return found->second;
    return ids_[id] = module_.freshId();
  }

  Instruction translated(const Instruction& instruction) {
    Instruction copy = instruction;
    copy.line = {};
    copy.type_id = translate(copy.type_id);
    for (Operand& operand : copy.operands)
      if (operand.is_id) operand.words[0] = translate(operand.words[0]);
    return copy;
  }

  void importSets() {
    for (const Instruction& import : frame_.imports) {
      const auto same = std::find_if(module_.imports.begin(), module_.imports.end(),
                                     [&](const Instruction& other) { return other.operands == import.operands; });
      if (same != module_.imports.end()) {
        ids_[import.result_id] = same->result_id;
        continue;
      }
      Instruction copy = translated(import);
      copy.result_id = translate(import.result_id);
      module_.imports.push_back(std::move(copy));
    }
  }

  bool becomesPrivate(std::uint32_t host_variable) const {
    return std::any_of(bindings_.variables.begin(), bindings_.variables.end(), [&](const auto& entry) { return entry.second == host_variable; });
  }

  // The variable of the host that a variable of the frame is.
  std::optional<std::uint32_t> hostVariable(const Instruction& variable) const {
    const auto name = frame_names_.find(variable.result_id);
    const auto shared = name == frame_names_.end() ? bindings_.shared.end() : bindings_.shared.find(name->second);
    return shared == bindings_.shared.end() ? hostBuiltIn(variable) : shared->second;
  }

  std::optional<std::uint32_t> hostBuiltIn(const Instruction& variable) const {
    if (static_cast<StorageClass>(variable.word(0)) != StorageClass::Input) return std::nullopt;
    const auto built_in = decorationOf(frame_, variable.result_id, spv::Decoration::BuiltIn);
    if (!built_in) return std::nullopt;
    for (const Instruction& global : module_.globals)
      if (global.opcode == Op::OpVariable && static_cast<StorageClass>(global.word(0)) == StorageClass::Input &&
          decorationOf(module_, global.result_id, spv::Decoration::BuiltIn) == built_in && !becomesPrivate(global.result_id))
        return global.result_id;
    return std::nullopt;
  }

  void importGlobals() {
    for (const Instruction& global : frame_.globals) {
      Instruction copy = translated(global);
      if (isUniqueType(global.opcode)) {
        const auto same = std::find_if(module_.globals.begin(), module_.globals.end(), [&](const Instruction& other) {
          return other.opcode == copy.opcode && other.operands == copy.operands;
        });
        if (same != module_.globals.end()) {
          ids_[global.result_id] = same->result_id;
          continue;
        }
      }
      if (global.opcode == Op::OpVariable)
        if (const auto shared = hostVariable(global)) {
          ids_[global.result_id] = *shared;
          continue;
        }
      copy.result_id = translate(global.result_id);
      module_.globals.push_back(std::move(copy));
      imported_.insert(global.result_id);
    }
  }

  // Names and decorations of what was really imported; what the host has already keeps its own.
  void importAbout(const std::vector<Instruction>& from, std::vector<Instruction>& to) {
    std::unordered_set<std::uint32_t> bodies;
    for (const Function& function : frame_.functions) {
      if (bindings_.functions.count(frame_names_[function.id()]) != 0) continue;
      bodies.insert(function.id());
      for (const Instruction& parameter : function.parameters) bodies.insert(parameter.result_id);
      for (const Block& block : function.blocks)
        for (const Instruction& instruction : block.instructions) bodies.insert(instruction.result_id);
    }
    for (const Instruction& about : from) {
      if (about.operands.empty() || !about.operands[0].is_id) continue;
      if (imported_.count(about.word(0)) == 0 && bodies.count(about.word(0)) == 0) continue;
      to.push_back(translated(about));
    }
  }

  void importFunction(const Function& function) {
    Function copy;
    const auto withResult = [&](const Instruction& instruction) {
      Instruction moved = translated(instruction);
      moved.result_id = translate(instruction.result_id);
      return moved;
    };
    copy.definition = withResult(function.definition);
    for (const Instruction& parameter : function.parameters) copy.parameters.push_back(withResult(parameter));
    for (const Block& block : function.blocks) {
      copy.blocks.push_back({translate(block.label), {}});
      for (const Instruction& instruction : block.instructions)
        copy.blocks.back().instructions.push_back(withResult(instruction));
    }
    module_.functions.push_back(std::move(copy));
  }

  void replaceEntryPoints() {
    const Instruction& frame_entry = frame_.entry_points.front();
    Instruction entry = translated(frame_entry);
    std::vector<Instruction> modes;
    for (const auto* of_one : {static_cast<const std::vector<Instruction>*>(&module_.execution_modes), &frame_.execution_modes})
      for (Instruction mode : *of_one) {
        mode.operands[0] = entry.operands[1];
        if (std::find(modes.begin(), modes.end(), mode) == modes.end()) modes.push_back(std::move(mode));
      }
    for (const Instruction& host_entry : module_.entry_points)
      for (std::size_t i = 3; i < host_entry.operands.size(); ++i)
        if (std::find(entry.operands.begin() + 3, entry.operands.end(), host_entry.operands[i]) == entry.operands.end())
          entry.operands.push_back(host_entry.operands[i]);
    module_.entry_points = {std::move(entry)};
    module_.execution_modes = std::move(modes);
  }

  void takeOverVariables() {
    for (const auto& [name, host_variable] : bindings_.variables) {
      const auto found = std::find_if(frame_names_.begin(), frame_names_.end(),
                                      [&, wanted = name](const auto& entry) { return entry.second == wanted; });
      REPRISE_CHECK(found != frame_names_.end(), name);
      const std::uint32_t frame_variable = ids_.at(found->first);
      for (Function& function : module_.functions) useVariable(function, host_variable, frame_variable);
      removeId(module_, host_variable);
    }
  }

  // Inputs and outputs that nothing refers to any more: a hidden colour output would claim its location.
  void dropUnusedInterface() {
    std::unordered_set<std::uint32_t> used;
    for (const Function& function : module_.functions)
      for (const Block& block : function.blocks)
        for (const Instruction& instruction : block.instructions)
          for (const Operand& operand : instruction.operands)
            if (operand.is_id) used.insert(operand.words[0]);
    std::vector<std::uint32_t> unused;
    for (const Instruction& global : module_.globals) {
      if (global.opcode != Op::OpVariable || used.count(global.result_id) != 0) continue;
      const auto storage = static_cast<StorageClass>(global.word(0));
      if (storage == StorageClass::Input || storage == StorageClass::Output) unused.push_back(global.result_id);
    }
    for (const std::uint32_t variable : unused) removeId(module_, variable);
  }

  // Pointers into the variable change their storage class with it.
  void useVariable(Function& function, std::uint32_t from, std::uint32_t to) {
    std::unordered_set<std::uint32_t> pointers{to};
    for (Block& block : function.blocks)
      for (Instruction& instruction : block.instructions) {
        for (Operand& operand : instruction.operands)
          if (operand.is_id && operand.words[0] == from) operand.words[0] = to;
        const bool access = instruction.opcode == Op::OpAccessChain || instruction.opcode == Op::OpInBoundsAccessChain;
        if (!access || pointers.count(instruction.word(0)) == 0) continue;
        pointers.insert(instruction.result_id);
        const std::uint32_t pointee = findGlobal(module_, instruction.type_id)->word(1);
        instruction.type_id = pointerType(module_, StorageClass::Private, pointee);
      }
  }

  // From SPIR-V 1.4 on the interface lists every global variable, not only inputs and outputs.
  void listAllGlobals() {
    Instruction& entry = module_.entry_points.front();
    for (const Instruction& global : module_.globals) {
      if (global.opcode != Op::OpVariable) continue;
      const Operand variable = idOperand(global.result_id);
      if (std::find(entry.operands.begin() + 3, entry.operands.end(), variable) == entry.operands.end())
        entry.operands.push_back(variable);
    }
  }

  // Frames are SPIR-V 1.3, whose storage buffers older versions know by an extension.
  void declareStorageClass() {
    const bool used = std::any_of(module_.globals.begin(), module_.globals.end(), [](const Instruction& global) {
      return global.opcode == Op::OpVariable && static_cast<StorageClass>(global.word(0)) == StorageClass::StorageBuffer;
    });
    if (used) unite(module_.extensions, {makeInstruction(Op::OpExtension, 0, 0, {stringOperand("SPV_KHR_storage_buffer_storage_class")})});
  }

  Module module_;
  const Module& frame_;
  const FrameBindings& bindings_;
  std::unordered_map<std::uint32_t, std::string> frame_names_;
  std::unordered_map<std::uint32_t, std::uint32_t> ids_;
  std::unordered_set<std::uint32_t> imported_;
};

}  // namespace

Module linkFrame(const Module& host, const Module& frame, const FrameBindings& bindings) {
  REPRISE_CHECK(frame.entry_points.size() == 1, frame.entry_points.size());
  return Linker(host, frame, bindings).run();
}

}  // namespace reprise
