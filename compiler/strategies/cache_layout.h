// Where payload and depth of a candidate lie in history images, and the constants that encode them.
//
// A payload of n channels has ceil(n / 4) targets of four. Depth goes into the last target's spare alpha where that is a float
// channel; beside 8-bit payloads and full targets it has an image of its own, since 8 bits of depth confuse surfaces (law 10). A
// single channel of 16 bits that is left for the last target shares a two-channel image with the depth: half the memory of the
// four-channel format, and less to convert per fetch and store. rgba8 and rgba16
// scale the payload into the range that training saw; what lies outside is stored invalid. Not every device renders to the
// 16-bit unorm formats. Integers lie in UINT formats whatever the encoding; their depth has a float image of its
// own, as a sampler's border is 0 for floats only.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "runtime/package/recipe.h"

namespace reprise {

struct ValueRanges {
  float depth_near = 0.1f, depth_far = 100;  // view-linear depth that can occur
  // Payload as seen in training, by channel; used by rgba8 and rgba16. min == max: unknown, taken as [0, 1].
  ChannelFloats payload_min = {}, payload_max = {};
};

struct CacheLayout {
  std::vector<ResourceFormat> payload_formats;               // by target
  int last_channels = 1;                                     // of the payload in the last target, 1..4
  bool depth_in_alpha = true;                                // in the last channel of the last target
  ResourceFormat depth_format = ResourceFormat::kR16Sfloat;  // where not in alpha
  bool narrow = false;                                       // the last target: one channel of payload, depth in the second
  bool integer = false;                                      // kept bit by bit
  bool affine = false;                                       // payload is scaled into [0, 1]
  int bytes_per_pixel = 8;                                   // of one history; two are held
};

CacheLayout cacheLayout(int channels, Encoding encoding, bool integer = false);

// How to encode with a layout. Guards are stored as they are. The depth tolerance is
// quantization step + slope x footprint + relative epsilon, in stored units.
CacheConstants encodingConstants(const CacheLayout& layout, Encoding encoding, Filter filter, const ValueRanges& ranges,
                                 const std::vector<int>& guard_channels = {});

// The ranges that a recipe was made with: the inverse of encodingConstants, for making the same variant again.
ValueRanges rangesOf(const Recipe& recipe);

}  // namespace reprise
