// Local structs and arrays taken apart into one variable for each part.
//
//   struct S { vec3 a; float b[4]; } s;            vec3 s_a;  float s_b[4];
//   s.a = x; y = s.b[i]; t = s;             ->      s_a = x; y = s_b[i]; t = S(s_a, s_b);
//
// A part is a scalar, a vector, a matrix, or an array that is indexed dynamically or has too many elements. What is copied whole is
// copied part by part. Exact: values are only moved.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

inline constexpr std::uint32_t kMostSplitElements = 100;  // of one array; longer ones stay whole
inline constexpr std::size_t kMostSplitParts = 256;       // of one variable; those that have more stay whole

// Of one function.
Module splitVariables(const Module& module, std::uint32_t function);

}  // namespace reprise
