#include "cli/check/unsteady_pixels.h"

#include <fmt/format.h>

#include "cli/check/frame_laws.h"

namespace reprise {
namespace {

constexpr double kVisible = 1e-3;
constexpr double kMostUnsteady = 0.1;
constexpr float kNudges[] = {-0x1p-19f, -0x1p-21f, 0x1p-21f, 0x1p-19f};

}  // namespace

Result<std::vector<std::vector<bool>>> unsteadyPixels(const OriginalPlay& play, const std::vector<HarnessFrame>& originals) {
  std::vector<std::vector<bool>> unsteady;
  for (const HarnessFrame& original : originals) unsteady.emplace_back(original.depth.size(), false);
  for (const float nudge : kNudges) {
    HarnessOptions options = play.options;
    options.varying_nudge = nudge;
    REPRISE_ASSIGN(Harness harness, Harness::create(play.context, play.commands, play.interface, options));
    REPRISE_ASSIGN(Player player, harness.createPlayer(play.package, true));
    for (std::size_t frame = 0; frame < originals.size(); ++frame) {
      REPRISE_ASSIGN(const HarnessFrame nudged, harness.play(player, {static_cast<int>(frame), 1}));
      for (std::size_t pixel = 0; pixel < nudged.depth.size(); ++pixel)
        for (std::size_t output = 0; output < nudged.colors.size(); ++output)
          if (!samePixel(originals[frame].colors[output], nudged.colors[output], pixel, kVisible)) unsteady[frame][pixel] = true;
    }
  }
  return unsteady;
}

std::string whyMostlyUnsteady(const std::vector<std::vector<bool>>& unsteady, const std::vector<HarnessFrame>& originals) {
  for (std::size_t frame = 0; frame < originals.size(); ++frame) {
    std::size_t drawn = 0, shaky = 0;
    for (std::size_t pixel = 0; pixel < unsteady[frame].size(); ++pixel) {
      if (!covered(originals[frame], pixel)) continue;
      ++drawn;
      shaky += unsteady[frame][pixel] ? 1 : 0;
    }
    if (static_cast<double>(shaky) > kMostUnsteady * static_cast<double>(drawn))
      return fmt::format("the shader enlarges rounding errors in {} of {} covered pixels", shaky, drawn);
  }
  return "";
}

}  // namespace reprise
