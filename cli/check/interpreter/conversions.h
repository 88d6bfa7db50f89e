// Between integers and floats.
#pragma once

#include "cli/check/interpreter/machine.h"

namespace reprise::interpreter {

// OpConvert*, OpBitcast; null for others.
Handler conversionHandler(spv::Op op);

// The float of some bits that were made from `parts`: a constant where no float took part in them.
Scalar floatFromBits(std::uint64_t bits, std::uint32_t width, std::uint64_t computation, bool touched, bool undefined);

}  // namespace reprise::interpreter
