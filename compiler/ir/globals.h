// Types, constants and variables at module level, found or added. SPIR-V forbids two equal non-aggregate types, so a transform
// that needs one asks here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/ir/module.h"

namespace reprise {

// The id of a type or constant with this opcode, result type and operands; added at the end of the globals if absent.
// Not for structs and arrays, whose decorations make equal ones differ.
std::uint32_t findOrAddGlobal(Module& module, spv::Op opcode, std::uint32_t type_id, const std::vector<Operand>& operands);

std::uint32_t floatType(Module& module);
std::uint32_t uintType(Module& module);
std::uint32_t intType(Module& module);
std::uint32_t vectorType(Module& module, std::uint32_t component_type, std::uint32_t components);
std::uint32_t pointerType(Module& module, spv::StorageClass storage, std::uint32_t pointee);
std::uint32_t uintConstant(Module& module, std::uint32_t value);
std::uint32_t intConstant(Module& module, std::int32_t value);
std::uint32_t floatConstant(Module& module, float value);

// A new variable of its own, with a name.
std::uint32_t addVariable(Module& module, spv::StorageClass storage, std::uint32_t pointee, const std::string& name);

void addName(Module& module, std::uint32_t id, const std::string& name);
void addDecoration(Module& module, std::uint32_t id, spv::Decoration decoration, const std::vector<std::uint32_t>& literals = {});
// Names, decorations and interface entries of an id, and its global if it has one.
void removeId(Module& module, std::uint32_t id);

}  // namespace reprise
