// Terms as text, to be kept and compared by people and by slice_changes.h:
//
//   value = FMul(#1, 0.15)
//   #1 = Phi(0.0, FAdd(#1, FMul(#2, FAbs(Sin(CompositeExtract.0(#3))))), BranchConditional(SLessThan:bool(#4, 90)))
//
// What stands in several places, what meets itself again and what lies deep has a line of its own, in the order in which it is first named.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/candidates/slice_terms.h"

namespace reprise {

inline constexpr std::size_t kMostSliceTextBytes = 64 * 1024;

// Lines. Cut off after whole lines where they would be longer than that; the last one is then "...".
std::vector<std::string> textOf(const SliceTerms& terms, std::size_t most_bytes = kMostSliceTextBytes);

// The terms again; what has been cut off has kUnknownHead. None where it is no such text.
std::optional<SliceTerms> termsOfText(const std::vector<std::string>& lines);

// A part of it for a sentence: "FMul(varying position, 3.0)", cut off with "..." where it is longer.
std::string shortTextOf(const SliceTerms& terms, int term, std::size_t most_characters = 60);

}  // namespace reprise
