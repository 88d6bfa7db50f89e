// Spellings of the recipe's enumerations, one table each.
#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "runtime/package/recipe.h"

namespace reprise {
namespace {

template <typename Enum, std::size_t N>
const char* nameIn(const std::array<std::pair<Enum, const char*>, N>& table, Enum value) {
  for (const auto& [entry, name] : table)
    if (entry == value) return name;
  REPRISE_CHECK(false, static_cast<int>(value));
  return "";
}

template <typename Enum, std::size_t N>
std::optional<Enum> valueIn(const std::array<std::pair<Enum, const char*>, N>& table, const std::string& wanted) {
  for (const auto& [entry, name] : table)
    if (wanted == name) return entry;
  return std::nullopt;
}

constexpr std::array<std::pair<PatternKind, const char*>, 4> kPatterns = {
    {{PatternKind::kTiled, "tiled"}, {PatternKind::kRandom, "random"}, {PatternKind::kInterleaved, "interleaved"},
     {PatternKind::kWhole, "whole"}}};
constexpr std::array<std::pair<PreviousImage, const char*>, 2> kPreviousImages = {
    {{PreviousImage::kLastFrame, "frame"}, {PreviousImage::kOtherEye, "other_eye"}}};
constexpr std::array<std::pair<Filter, const char*>, 2> kFilters = {
    {{Filter::kNearest, "nearest"}, {Filter::kBilinear, "bilinear"}}};
constexpr std::array<std::pair<Encoding, const char*>, 4> kEncodings = {
    {{Encoding::kRgba8, "rgba8"}, {Encoding::kRgba16, "rgba16"}, {Encoding::kRgba16f, "rgba16f"}, {Encoding::kRgba32f, "rgba32f"}}};
constexpr std::array<std::pair<ResourceFormat, const char*>, 12> kFormats = {
    {{ResourceFormat::kRgba8Unorm, "rgba8_unorm"},
     {ResourceFormat::kRg16Unorm, "rg16_unorm"},
     {ResourceFormat::kRgba16Unorm, "rgba16_unorm"},
     {ResourceFormat::kRg16Sfloat, "rg16_sfloat"},
     {ResourceFormat::kRgba16Sfloat, "rgba16_sfloat"},
     {ResourceFormat::kRgba32Sfloat, "rgba32_sfloat"},
     {ResourceFormat::kR32Uint, "r32_uint"},
     {ResourceFormat::kRg32Uint, "rg32_uint"},
     {ResourceFormat::kRgba32Uint, "rgba32_uint"},
     {ResourceFormat::kR8Unorm, "r8_unorm"},
     {ResourceFormat::kR16Sfloat, "r16_sfloat"},
     {ResourceFormat::kR32Sfloat, "r32_sfloat"}}};

}  // namespace

const char* nameOf(PatternKind kind) { return nameIn(kPatterns, kind); }
const char* nameOf(PreviousImage previous) { return nameIn(kPreviousImages, previous); }
const char* nameOf(Filter filter) { return nameIn(kFilters, filter); }
const char* nameOf(Encoding encoding) { return nameIn(kEncodings, encoding); }
const char* nameOf(ResourceFormat format) { return nameIn(kFormats, format); }
std::optional<PatternKind> patternKindOf(const std::string& name) { return valueIn(kPatterns, name); }
std::optional<PreviousImage> previousImageOf(const std::string& name) { return valueIn(kPreviousImages, name); }
std::optional<Filter> filterOf(const std::string& name) { return valueIn(kFilters, name); }
std::optional<Encoding> encodingOf(const std::string& name) { return valueIn(kEncodings, name); }
std::optional<ResourceFormat> resourceFormatOf(const std::string& name) { return valueIn(kFormats, name); }

int bytesPerPixel(ResourceFormat format) {
  switch (format) {
    case ResourceFormat::kRgba8Unorm: return 4;
    case ResourceFormat::kRg16Unorm: return 4;
    case ResourceFormat::kRgba16Unorm: return 8;
    case ResourceFormat::kRg16Sfloat: return 4;
    case ResourceFormat::kRgba16Sfloat: return 8;
    case ResourceFormat::kRgba32Sfloat: return 16;
    case ResourceFormat::kR32Uint: return 4;
    case ResourceFormat::kRg32Uint: return 8;
    case ResourceFormat::kRgba32Uint: return 16;
    case ResourceFormat::kR8Unorm: return 1;
    case ResourceFormat::kR16Sfloat: return 2;
    case ResourceFormat::kR32Sfloat: return 4;
  }
  return 0;
}

bool isUint(ResourceFormat format) {
  return format == ResourceFormat::kR32Uint || format == ResourceFormat::kRg32Uint ||
         format == ResourceFormat::kRgba32Uint;
}

std::string payloadTarget(std::size_t target) { return target == 0 ? "cache" : "cache" + std::to_string(target); }

}  // namespace reprise
