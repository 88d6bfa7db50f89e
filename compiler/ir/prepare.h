// A shader brought into the form that analysis and rewriting work on: one function in SSA form, whose values still know
// what the source called them.
//
// Short loops are written out (unroll.h), and what other loops leave behind is a value of its own (loop_results.h).
//
// SSA construction drops the variables and with them their names. So before it every store to a named local is given a
// copy that carries the name; afterwards the copies are folded into the values they copied. Where several names meet in
// one value the last assignment in program order wins: that is the outermost one after inlining.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "compiler/ir/module.h"

namespace reprise {

struct NamedValue {
  std::string name;
  LineMark line;  // of the assignment
};

struct PreparedShader {
  Module module;
  std::uint32_t entry_function = 0;
  std::unordered_map<std::uint32_t, NamedValue> named;  // by result id
  std::unordered_set<std::uint32_t> return_flags;       // values that inlining made, no candidates (return_flags.h)
};

// Errors: spirv.entry_point (kInput; there is no entry point `entry_point`, or not exactly one where it is empty),
// those of optimize.h; call.kept (kRefused) where a call could not be inlined.
Result<PreparedShader> prepareForCaching(const Module& module, const std::string& entry_point);

// Types of all results of a module, by id.
std::unordered_map<std::uint32_t, std::uint32_t> resultTypes(const Module& module);

}  // namespace reprise
