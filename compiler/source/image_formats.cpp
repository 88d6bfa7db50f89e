#include "compiler/source/image_formats.h"

#include <spirv_cross/spirv_cross.hpp>

namespace reprise {

std::string formatName(std::uint32_t format) {
  switch (static_cast<spv::ImageFormat>(format)) {
    case spv::ImageFormatUnknown: return "";
    case spv::ImageFormatRgba32f: return "rgba32f";
    case spv::ImageFormatRgba16f: return "rgba16f";
    case spv::ImageFormatR32f: return "r32f";
    case spv::ImageFormatRgba8: return "rgba8";
    case spv::ImageFormatRgba8Snorm: return "rgba8_snorm";
    case spv::ImageFormatRg32f: return "rg32f";
    case spv::ImageFormatRg16f: return "rg16f";
    case spv::ImageFormatR11fG11fB10f: return "r11f_g11f_b10f";
    case spv::ImageFormatR16f: return "r16f";
    case spv::ImageFormatRgba16: return "rgba16";
    case spv::ImageFormatRgb10A2: return "rgb10_a2";
    case spv::ImageFormatRg16: return "rg16";
    case spv::ImageFormatRg8: return "rg8";
    case spv::ImageFormatR16: return "r16";
    case spv::ImageFormatR8: return "r8";
    case spv::ImageFormatRgba16Snorm: return "rgba16_snorm";
    case spv::ImageFormatRg16Snorm: return "rg16_snorm";
    case spv::ImageFormatRg8Snorm: return "rg8_snorm";
    case spv::ImageFormatR16Snorm: return "r16_snorm";
    case spv::ImageFormatR8Snorm: return "r8_snorm";
    case spv::ImageFormatRgba32i: return "rgba32i";
    case spv::ImageFormatRgba16i: return "rgba16i";
    case spv::ImageFormatRgba8i: return "rgba8i";
    case spv::ImageFormatR32i: return "r32i";
    case spv::ImageFormatRg32i: return "rg32i";
    case spv::ImageFormatRg16i: return "rg16i";
    case spv::ImageFormatRg8i: return "rg8i";
    case spv::ImageFormatR16i: return "r16i";
    case spv::ImageFormatR8i: return "r8i";
    case spv::ImageFormatRgba32ui: return "rgba32ui";
    case spv::ImageFormatRgba16ui: return "rgba16ui";
    case spv::ImageFormatRgba8ui: return "rgba8ui";
    case spv::ImageFormatR32ui: return "r32ui";
    case spv::ImageFormatRgb10a2ui: return "rgb10_a2ui";
    case spv::ImageFormatRg32ui: return "rg32ui";
    case spv::ImageFormatRg16ui: return "rg16ui";
    case spv::ImageFormatRg8ui: return "rg8ui";
    case spv::ImageFormatR16ui: return "r16ui";
    case spv::ImageFormatR8ui: return "r8ui";
    default: return "other";
  }
}

}  // namespace reprise
