// Which frames of a session packages are compared with the original in (laws 1 and 3), and where the original's colours lie meanwhile.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace reprise {

// Eight frames, ascending: four pairs of neighbours, spread over a session of `frames` frames, each from an even one on (a left eye, in
// stereo); all of a session that has no more.
std::vector<int> lawFrames(int frames);

// The one of them whose inputs are held still.
int frozenFrame(int frames);

// RGBA floats of 32 bits, rows from the top, nothing else.
std::filesystem::path referenceFile(const std::string& directory, int frame, std::size_t output);

}  // namespace reprise
