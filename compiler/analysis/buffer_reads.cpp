#include "compiler/analysis/buffer_reads.h"

#include <optional>
#include <unordered_map>

namespace reprise {
namespace {

using spv::Op;
using spv::StorageClass;

class BufferPointers {
 public:
  BufferPointers(const Module& module, const ValueGraph& graph) : module_(module), graph_(graph), types_(resultTypes(module)) {
    for (const Instruction& global : module.globals) globals_[global.result_id] = &global;
  }

  bool isOne(std::uint32_t pointer) const {
    const auto type = types_.find(pointer);
    if (type == types_.end()) return false;
    const Instruction* pointer_type = globalOf(type->second);
    if (pointer_type == nullptr || pointer_type->opcode != Op::OpTypePointer) return false;
    switch (static_cast<StorageClass>(pointer_type->word(0))) {
      case StorageClass::StorageBuffer:
      case StorageClass::PhysicalStorageBuffer: return true;
      case StorageClass::Uniform: return isOldBuffer(pointer);
      default: return false;
    }
  }

 private:
  const Instruction* globalOf(std::uint32_t id) const {
    const auto found = globals_.find(id);
    return found == globals_.end() ? nullptr : found->second;
  }

  // Before SPIR-V 1.3 a storage buffer was a uniform variable whose block is so decorated.
  bool isOldBuffer(std::uint32_t pointer) const {
    for (auto found = graph_.node_of.find(pointer); found != graph_.node_of.end(); found = graph_.node_of.find(pointer)) {
      const Instruction& instruction = *graph_.nodes[static_cast<std::size_t>(found->second)].instruction;
      if (instruction.operands.empty() || !instruction.operands[0].is_id) return false;
      pointer = instruction.word(0);
    }
    const Instruction* variable = globalOf(pointer);
    const Instruction* type = variable == nullptr ? nullptr : globalOf(variable->type_id);
    if (type == nullptr || type->opcode != Op::OpTypePointer) return false;
    std::uint32_t block = type->word(1);
    for (const Instruction* array = globalOf(block); array != nullptr && (array->opcode == Op::OpTypeArray || array->opcode == Op::OpTypeRuntimeArray);
         array = globalOf(block))
      block = array->word(0);
    return decorationOf(module_, block, spv::Decoration::BufferBlock).has_value();
  }

  const Module& module_;
  const ValueGraph& graph_;
  std::unordered_map<std::uint32_t, std::uint32_t> types_;
  std::unordered_map<std::uint32_t, const Instruction*> globals_;
};

}  // namespace

std::vector<bool> readsOfBuffers(const Module& module, const ValueGraph& graph) {
  const BufferPointers buffers(module, graph);
  std::vector<bool> reads(graph.nodes.size(), false);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const Instruction& instruction = *graph.nodes[i].instruction;
    reads[i] = instruction.opcode == Op::OpLoad && buffers.isOne(instruction.word(0));
  }
  return reads;
}

}  // namespace reprise
