// Mutations of a SPIR-V module that keep its instructions whole: most byte flips would end at the parser.
//
// An operand is set to another word of the module or to a number at the edge of something, an opcode is taken from a like
// instruction, instructions are dropped, doubled under a fresh id, swapped or moved. Nothing is promised of the result.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace reprise {

// `most_words` bounds the result. Words that are no module are left as they are.
void mutateWords(std::vector<std::uint32_t>& words, std::size_t most_words, std::minstd_rand& random);

}  // namespace reprise
