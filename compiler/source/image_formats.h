// Formats of storage images.
#pragma once

#include <spirv_cross/spirv_cross.hpp>
#include <string>

namespace reprise {

// GLSL's name ("rgba8_snorm"); "" for an image that names none, "other" for what GLSL has no name for.
std::string formatName(spv::ImageFormat format);

}  // namespace reprise
