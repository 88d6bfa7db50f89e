// Which integers `check` tries in all pairs of small values: those that decide how often loops run and which way branches go.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/strategies/shader_program.h"
#include "profiler/harness/integer_inputs.h"

namespace reprise {

// More are left out, those of branches before those of loops and switches.
inline constexpr std::size_t kMostCoveredIntegers = 12;

std::vector<IntegerInput> decidingIntegers(const ShaderProgram& program);

// One for each render, at most most_rows; none where no integer input decides anything. For HarnessOptions::integers.
std::vector<IntegerAssignment> coveringAssignments(const ShaderProgram& program, std::size_t most_rows);

}  // namespace reprise
