// Names that the user may have meant.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace reprise {

// Levenshtein distance, ASCII letters compared without case; two neighbouring letters swapped count as one
// edit (optimal string alignment).
int editDistance(const std::string& a, const std::string& b);

// The known names within a third of the length of `name` (at least 2 edits), nearest first, at most three. A
// name that ends in ".name" or that `name` ends in so is near, too: the block before the dot may be what is
// wrong.
std::vector<std::string> nearNames(const std::string& name, std::span<const std::string> known);

// "; did you mean 'frames'?", or "; expected one of 'a', 'b'" where nothing is near, or "" where nothing is
// known.
std::string suggestNames(const std::string& name, std::span<const std::string> known);

}  // namespace reprise
