// What the reference interpreter says of a module and its prepared form.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "cli/check/judgement.h"

namespace reprise {

struct Interpreted {
  Computation computation = Computation::kUnknown;
  std::string text;  // of a difference: where, and what; of kUnknown: why
};

// Both have passed the validator and have one entry point.
Interpreted interpretPrepared(std::span<const std::uint32_t> given, std::span<const std::uint32_t> prepared);

}  // namespace reprise
