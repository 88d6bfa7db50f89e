// A recorded camera path: from a file (.csv or .json, recording_rows.h), or from rows that stand in the scenario itself, as
// writeScenario leaves them: arrays of 8 or 9 numbers in the order of the columns.
#pragma once

#include <filesystem>
#include <string>

#include "profiler/scenario/table_reader.h"

namespace reprise {

// How far a quaternion's length may be from 1; within that it is normalised.
inline constexpr double kQuaternionTolerance = 0.01;

// Times count from the first row. Errors: scenario.recording at the row: a number that is not finite, times that do not rise, a
// rotation that is not a unit quaternion, an angle of view outside (0, 170] or given in some rows only; no rows or too many.
RecordedPath readRecording(const TomlNode& node, const std::string& what, const std::filesystem::path& directory, Diagnostics& diagnostics);

}  // namespace reprise
