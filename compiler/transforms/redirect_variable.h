// A function made to use another variable in place of a global one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/ir/module.h"

namespace reprise {

struct Redirection {
  std::uint32_t function = 0;
  std::uint32_t from = 0;       // a global variable
  std::uint32_t to = 0;         // another, whose type may differ from `from`'s only by what follows
  // Members to step into before `from`'s own indices: {1} makes from.x into to.member1.x.
  std::vector<std::uint32_t> prefix;
  // `to` is this member alone: access chains to it lose their first index, those to other members are left as they are.
  std::optional<std::uint32_t> drop_member;
};

// Access chains, loads and stores through `from` go through `to`, with pointers of to's storage class. Errors (kRefused):
// variable.use, where the function uses `from` in another way than by access chain, load or store.
Result<Module> redirectVariable(const Module& module, const Redirection& redirection);

// Which outputs to hide: those with a Location, or depth and sample mask too.
enum class HiddenOutputs { kColors, kAll };

// Outputs become private variables in the function: its stores reach nobody (unless the function reads them back). Output
// `except` stays (0: none does).
Result<Module> hideOutputs(const Module& module, std::uint32_t function, HiddenOutputs hidden, std::uint32_t except = 0);

}  // namespace reprise
