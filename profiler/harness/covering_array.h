// Few rows of values in which every two columns show every pair of values: most faults that need particular values need
// at most two of them. Greedy, in the manner of Cohen et al., "The AETG System" (1997).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace reprise {

// Rows of `columns` numbers in 0..values-1. With one column each value once; with none no row. At most most_rows: where more would be
// needed, those that show the most new pairs come first. The same arguments give the same rows.
std::vector<std::vector<std::uint32_t>> coveringArray(std::size_t columns, std::uint32_t values, std::size_t most_rows);

}  // namespace reprise
