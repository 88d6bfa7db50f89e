// What was changed between two versions of a slice, in words.
//
// The fewest edits that make the terms before into those after, with the cost of
//   another constant or input                  1
//   another operation with the same parts      2
//   an operation around what was there, or one less around it   1 + the size of its other parts, if the rest has something in common
//   anything else                              the sizes of both
// found by comparing pairs from the wholes down; where too many pairs would have to be compared, operations are not searched for ones
// around them any more, so that some edits are then told as larger than they are.
#pragma once

#include <string>
#include <vector>

#include "compiler/candidates/slice_terms.h"

namespace reprise {

struct SliceChange {
  std::string text;    // "the constant 0.5 is now 0.6", "texture 'noise' is read in place of 'detail'", "there is an added `FAdd` of 0.1"
  int node = kNoNode;  // of the terms after: where to look
  bool gone = false;   // nothing is left of a kept term
  bool operator==(const SliceChange&) const = default;
};

// In the order in which they are met; each text once. None where the terms are equal.
std::vector<SliceChange> changesBetween(const SliceTerms& before, const SliceTerms& after);

// Of parts of chains: what became of the kept terms before, among all terms of the chain after; others may be anything.
std::vector<SliceChange> changesOfKept(const SliceTerms& kept_before, const SliceTerms& all_after);

// How much of the terms before was edited: the cost over their size; 0 where they are equal.
double shareEdited(const SliceTerms& before, const SliceTerms& after);

}  // namespace reprise
