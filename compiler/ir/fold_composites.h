// Parts taken from structs, arrays and matrices that were just put together.
//
//   s = CompositeConstruct(a, b);  x = CompositeExtract(s, 1)        ->  b for x
//   t = CompositeInsert(c, s, 0);  y = CompositeExtract(t, 1)        ->  b for y
//
// Exact: values are only moved. Vectors are left alone: drivers see through them, and the values of a shader stay what its author wrote.
#pragma once

#include "compiler/ir/module.h"

namespace reprise {

Module foldComposites(const Module& module, std::uint32_t function);

}  // namespace reprise
