// What the reference interpreter says of the bodies that a variant is made from.
//
// A variant's modules look up a history that no interpreter has. What they compute of the shader are its bodies (compiler/strategies/
// payload_bodies.h): the one of misses, and the one of hits, which takes the payload as given. Joined, the second takes what the first
// hands out:
//
//   void main() { miss_body(); hit_body(); }    // the outputs of the second stand
//
// Equal terms prove that misses compute what the module as given does, and hits too where the payload is that of their own fragment. For
// parts of regrouped chains, whose hits have other terms and a tolerance of their own, the body of misses is looked at alone.
#pragma once

#include <cstdint>
#include <span>

#include "cli/check/interpreted.h"
#include "compiler/candidates/enumerate.h"
#include "compiler/ir/prepare.h"

namespace reprise {

// given: the module as given, with one entry point. kUnknown where the bodies cannot be made.
Interpreted interpretBodies(std::span<const std::uint32_t> given, const PreparedShader& shader, const Candidate& candidate);

}  // namespace reprise
