// Formats of storage images.
#pragma once

#include <cstdint>
#include <string>

namespace reprise {

// GLSL's name ("rgba8_snorm"); "" for an image that names none, "other" for what GLSL has no name for.
std::string formatName(std::uint32_t format);  // an ImageFormat of SPIR-V

}  // namespace reprise
