#include "profiler/session/law_frames.h"

namespace reprise {
namespace {

constexpr int kPairs = 4;

}  // namespace

std::vector<int> lawFrames(int frames) {
  std::vector<int> chosen;
  if (frames <= 2 * kPairs) {
    for (int frame = 0; frame < frames; ++frame) chosen.push_back(frame);
    return chosen;
  }
  for (int pair = 0; pair < kPairs; ++pair) {
    const int first = pair * (frames - 2) / (kPairs - 1) / 2 * 2;
    chosen.insert(chosen.end(), {first, first + 1});
  }
  return chosen;
}

int frozenFrame(int frames) {
  const std::vector<int> chosen = lawFrames(frames);
  return chosen[chosen.size() / 2 / 2 * 2];
}

std::filesystem::path referenceFile(const std::string& directory, int frame, std::size_t output) {
  return std::filesystem::path(directory) / ("frame_" + std::to_string(frame) + "_output_" + std::to_string(output) + ".rgba32f");
}

}  // namespace reprise
