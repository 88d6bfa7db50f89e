// A picture as it stands in the page: the PNG as it is, or a JPEG of it where the page would grow too large.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reprise {

// "data:image/png;base64,..."
std::string pngDataUri(const std::vector<std::uint8_t>& png);

// No wider than `most_width` pixels (shrunk by averaging whole pixels), quality of JPEG 1 to 100. nullopt if it is no PNG.
std::optional<std::string> jpegDataUri(const std::vector<std::uint8_t>& png, int most_width, int quality);

}  // namespace reprise
