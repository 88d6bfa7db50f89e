// The rows of a recorded camera path, as CSV or JSON has them; what they must hold is checked by readRecording.
//
// CSV: the header `at_s,x,y,z,qx,qy,qz,qw`, with `,fov_y_deg` at its end if wanted, then a row of numbers a line; empty lines and
// lines that begin with # are skipped. JSON: a list of objects with those keys, and nothing else.
#pragma once

#include <string>
#include <vector>

#include "profiler/scenario/diagnostics.h"

namespace reprise {

inline constexpr const char* kRecordingColumns[] = {"at_s", "x", "y", "z", "qx", "qy", "qz", "qw", "fov_y_deg"};
inline constexpr std::size_t kFewestColumns = 8;  // without fov_y_deg

// As many numbers as columns, in their order; NaN and infinity are still possible.
struct RecordingRow {
  Place place;
  std::vector<double> numbers;
};

// Reading stops behind kMaxCameraRows rows. Errors: scenario.recording, one for each row that cannot be read.
std::vector<RecordingRow> rowsOfCsv(const std::string& text, const std::string& file, Diagnostics& diagnostics);
std::vector<RecordingRow> rowsOfJson(const std::string& text, const std::string& file, Diagnostics& diagnostics);

}  // namespace reprise
