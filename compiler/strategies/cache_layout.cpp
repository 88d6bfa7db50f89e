#include "compiler/strategies/cache_layout.h"

#include <algorithm>
#include <cmath>

namespace reprise {
namespace {

// Stored depth spans [kNearestStored, 1], away from 0, which means "invalid".
constexpr float kNearestStored = 1.0f / 16;
constexpr float kHalfStep = 1.0f / 2048;           // spacing of 16-bit floats in [0.5, 1)
constexpr float kUnorm16Step = 1.0f / 65535;
constexpr float kFloatStep = 1.0f / (1 << 20);     // interpolation noise of 32-bit floats, some units in the last place
constexpr float kRelativeEpsilon = 1e-4f;
constexpr float kSlopeCap = 0.01f;
constexpr float kLargestHalf = 65504;
constexpr float kLargestFloat = 3.0e38f;
constexpr float kRangeMargin = 0.02f;

float depthStep(const CacheLayout& layout, Encoding encoding) {
  if (!layout.depth_in_alpha) return layout.depth_format == ResourceFormat::kR16Sfloat ? kHalfStep : kFloatStep;
  switch (encoding) {
    case Encoding::kRgba16: return kUnorm16Step;
    case Encoding::kRgba16f: return kHalfStep;
    default: return kFloatStep;
  }
}

struct TargetFormats {
  ResourceFormat four, two;
};

CacheLayout floatLayout(int channels, Encoding encoding) {
  CacheLayout layout;
  layout.last_channels = (channels - 1) % 4 + 1;
  layout.affine = encoding == Encoding::kRgba8 || encoding == Encoding::kRgba16;
  layout.depth_in_alpha = encoding != Encoding::kRgba8 && layout.last_channels < 4;
  const bool sixteen_bits = encoding == Encoding::kRgba16 || encoding == Encoding::kRgba16f;
  layout.narrow = sixteen_bits && layout.last_channels == 1;
  if (encoding == Encoding::kRgba32f) layout.depth_format = ResourceFormat::kR32Sfloat;
  const TargetFormats formats =
      encoding == Encoding::kRgba8    ? TargetFormats{ResourceFormat::kRgba8Unorm, ResourceFormat::kRgba8Unorm}
      : encoding == Encoding::kRgba16 ? TargetFormats{ResourceFormat::kRgba16Unorm, ResourceFormat::kRg16Unorm}
      : encoding == Encoding::kRgba16f ? TargetFormats{ResourceFormat::kRgba16Sfloat, ResourceFormat::kRg16Sfloat}
                                       : TargetFormats{ResourceFormat::kRgba32Sfloat, ResourceFormat::kRgba32Sfloat};
  layout.payload_formats.assign(static_cast<std::size_t>((channels + 3) / 4), formats.four);
  if (layout.narrow) layout.payload_formats.back() = formats.two;
  return layout;
}

CacheLayout integerLayout(int channels) {
  CacheLayout layout;
  layout.last_channels = (channels - 1) % 4 + 1;
  layout.payload_formats.assign(static_cast<std::size_t>((channels + 3) / 4), ResourceFormat::kRgba32Uint);
  if (layout.last_channels == 1) layout.payload_formats.back() = ResourceFormat::kR32Uint;
  if (layout.last_channels == 2) layout.payload_formats.back() = ResourceFormat::kRg32Uint;
  layout.depth_in_alpha = false;
  layout.depth_format = ResourceFormat::kR32Sfloat;
  layout.integer = true;
  return layout;
}

}  // namespace

CacheLayout cacheLayout(int channels, Encoding encoding, bool integer) {
  REPRISE_CHECK(channels >= 1 && channels <= static_cast<int>(kMostPayloadChannels), channels);
  CacheLayout layout = integer ? integerLayout(channels) : floatLayout(channels, encoding);
  layout.bytes_per_pixel = layout.depth_in_alpha ? 0 : bytesPerPixel(layout.depth_format);
  for (const ResourceFormat format : layout.payload_formats) layout.bytes_per_pixel += bytesPerPixel(format);
  return layout;
}

CacheConstants encodingConstants(const CacheLayout& layout, Encoding encoding, Filter filter, const ValueRanges& ranges,
                                 const std::vector<int>& guard_channels) {
  CacheConstants constants;
  const float span = std::max(ranges.depth_far - ranges.depth_near, 1e-6f * std::max(1.0f, std::abs(ranges.depth_far)));
  constants.depth_range[0] = (1 - kNearestStored) / span;
  constants.depth_range[1] = kNearestStored - ranges.depth_near * constants.depth_range[0];
  constants.depth_range[2] = kNearestStored * 0.99f;
  constants.depth_range[3] = 1.001f;
  constants.tolerance[0] = depthStep(layout, encoding);
  // A nearest fetch is up to half a pixel off in each direction; a filtered one only as far as depth bends over a pixel.
  constants.tolerance[1] = filter == Filter::kNearest ? 0.75f : 0.5f;
  constants.tolerance[2] = kRelativeEpsilon;
  constants.tolerance[3] = kSlopeCap;
  constants.payload_scale.fill(1);
  const float largest = encoding == Encoding::kRgba16f ? kLargestHalf : kLargestFloat;
  constants.payload_range[0] = -largest;
  constants.payload_range[1] = largest;
  if (layout.affine) {
    for (std::size_t channel = 0; channel < kMostPayloadChannels; ++channel) {
      if (std::find(guard_channels.begin(), guard_channels.end(), static_cast<int>(channel)) != guard_channels.end()) continue;
      float low = ranges.payload_min[channel], high = ranges.payload_max[channel];
      if (!(high > low) || !std::isfinite(high - low)) low = 0, high = 1;
      const float margin = (high - low) * kRangeMargin;
      constants.payload_scale[channel] = 1 / (high - low + 2 * margin);
      constants.payload_offset[channel] = -(low - margin) * constants.payload_scale[channel];
    }
    constants.payload_range[0] = 0;
    constants.payload_range[1] = 1;
  }
  for (std::size_t channel = 0; channel < kMostPayloadChannels; ++channel)
    constants.free_payload[channel] = (ranges.payload_min[channel] + ranges.payload_max[channel]) / 2;
  return constants;
}

ValueRanges rangesOf(const Recipe& recipe) {
  ValueRanges ranges;
  const float scale = recipe.constants.depth_range[0], offset = recipe.constants.depth_range[1];
  if (scale != 0) {
    ranges.depth_near = (kNearestStored - offset) / scale;
    ranges.depth_far = (1 - offset) / scale;
  }
  for (const PayloadValue& value : recipe.payload)
    for (int channel = 0; channel < value.channels; ++channel) {
      const auto at = static_cast<std::size_t>(value.first_channel + channel);
      ranges.payload_min[at] = value.range_min[static_cast<std::size_t>(channel)];
      ranges.payload_max[at] = value.range_max[static_cast<std::size_t>(channel)];
    }
  return ranges;
}

}  // namespace reprise
