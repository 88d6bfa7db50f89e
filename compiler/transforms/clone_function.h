// A second copy of a function, with ids of its own; names and decorations come along.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "compiler/ir/module.h"

namespace reprise {

struct ClonedFunction {
  Module module;
  std::uint32_t function = 0;                                // id of the copy
  std::unordered_map<std::uint32_t, std::uint32_t> copy_of;  // original id -> the copy's
};

ClonedFunction cloneFunction(const Module& module, std::uint32_t function);

// Adds an entry point for a function, with the interface and the execution modes of entry point `like` (its function id).
Module addEntryPoint(const Module& module, std::uint32_t function, const std::string& name, std::uint32_t like);

}  // namespace reprise
