// A variant as data: what an application (or the profiler) has to create, bind and draw to play it.
//
// A frame of a recipe is its passes in order. Consecutive passes with the same `rendering` number share one rendering
// instance (same attachments, no barrier between). Colour attachment `kAppTarget` i is the application's i-th colour target;
// any other attachment and every read names a resource. The player applies the load operation of an attachment's first pass.
//
// Reprise's own descriptors lie in one set, `reprise_set`, the first that the application's shaders leave free:
//   binding 0             uniform buffer FrameUniforms (below), one per frame
//   binding 1             uniform buffer, dynamic offset, one per draw: uint valid_last_frame at 0 (0 for a draw id that was
//                         absent last frame), uint at 4: which of the frame's draws it is, the push constants of last frame from byte 16 on
//   bindings 2..          combined image samplers of the pass's `reads`
//   binding 15            where the recipe flags misses: storage buffer, a uint for each tile of the target, row by row, or for each draw;
//                         0 at the start of a frame
//   bindings 16..         uniform buffers, dynamic offset: last frame's content of the blocks in `previous_inputs`
// The layout is the same for all passes of a recipe; bindings that a pass does not read may hold any valid image.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/check.h"
#include "runtime/package/interface.h"

namespace reprise {

inline constexpr int kRecipeFormatVersion = 7;
inline constexpr std::size_t kMostColorTargets = 8;  // of a pass; every desktop device has as many
inline constexpr std::size_t kMostPayloadTargets = 4;                              // of four channels each
inline constexpr std::size_t kMostPayloadChannels = 4 * kMostPayloadTargets;

// A number for each channel of a payload; channel c lies in target c / 4.
using ChannelFloats = std::array<float, kMostPayloadChannels>;

// kWhole: one group, that is, frames that are due as a whole and frames that are not due at all.
enum class PatternKind { kTiled, kRandom, kInterleaved, kWhole };
inline constexpr PatternKind kPatternKinds[] = {PatternKind::kTiled, PatternKind::kRandom, PatternKind::kInterleaved, PatternKind::kWhole};
enum class Filter { kNearest, kBilinear };
enum class Encoding { kRgba8, kRgba16, kRgba16f, kRgba32f };  // unorm in the trained range: rgba8, rgba16

// Spellings of the command line, of files and of reports: "tiled", "nearest", "rgba16f".
const char* nameOf(PatternKind kind);
const char* nameOf(Filter filter);
const char* nameOf(Encoding encoding);
std::optional<PatternKind> patternKindOf(const std::string& name);
std::optional<Filter> filterOf(const std::string& name);
std::optional<Encoding> encodingOf(const std::string& name);

// Periods are 1, 2, 4, ... 64; kNeverRefresh stands for "never" (null in JSON).
inline constexpr std::uint32_t kNeverRefresh = 0;

// The group of pixel (x, y), an integer in [0, n) for period n: the pixel is due in frame f when group == f mod n.
// block is the edge of a refresh block in pixels, a power of two and at least 2; width, height are the target's. n must be a power of
// two; never-refresh has no groups.
std::uint32_t refreshGroup(PatternKind kind, std::uint32_t x, std::uint32_t y, std::uint32_t period_frames,
                           std::uint32_t block, std::uint32_t width, std::uint32_t height);

// The pixels that are due in a frame, in the form that the shader tests: for random and interleaved {mask, turn}, due where
// (key & mask) == turn for the hash of a block or its packed coordinates x | y << 16; for tiled the rectangle {x0, y0, x1, y1} in
// pixels, right and bottom excluded; for whole the first word, 1 where every pixel is due, else 0. Never-refresh gives what no
// pixel matches.
struct DueBlocks {
  std::uint32_t words[4] = {0, 1, 0, 0};
  bool operator==(const DueBlocks&) const = default;
};

struct Refresh {
  PatternKind pattern = PatternKind::kInterleaved;
  std::uint32_t period_frames = 1;
  std::uint32_t block_pixels = 16;
};

DueBlocks dueBlocks(const Refresh& refresh, std::uint32_t frame, std::uint32_t width, std::uint32_t height);

// Whether the pattern makes every pixel of a frame due, known without looking at one: true for whole in frames 0, n, 2n, ...
bool isWhollyDue(const Refresh& refresh, std::uint32_t frame);

// refreshGroup(...) == frame mod n, by the test of the shader; false for never-refresh.
bool isDue(const DueBlocks& due, const Refresh& refresh, std::uint32_t x, std::uint32_t y);

// std140 image of reprise_set binding 0. Filled by the player once a frame.
struct FrameUniforms {
  std::uint32_t frame = 0;            // counts from 0
  std::uint32_t period_frames = 1;    // kNeverRefresh: never
  std::uint32_t history_valid = 0;    // 0 in frame 0 and after invalidate(): every pixel misses
  std::uint32_t tiles = 0;            // of the target: across | down << 16; where the recipe flags tiles
  float viewport[4] = {};             // x, y, width, signed height (pixels) of this frame
  float previous_viewport[4] = {};    // of the last frame
  DueBlocks due;
  ChannelFloats free_payload = {};    // payload of the tail-only limit; no constant, or compilers would fold the tail
};
static_assert(sizeof(FrameUniforms) == 16 * 8);

// How payload and depth are encoded. The modules have these numbers as constants; the recipe tells them.
struct CacheConstants {
  float depth_range[4] = {};              // stored = depth * [0] + [1]; valid stored values lie in [2]..[3]
  float tolerance[4] = {};                // quantization step, slope factor (footprint, pixels), relative epsilon, slope cap; stored units
  ChannelFloats payload_scale = {};       // stored = payload * scale + offset
  ChannelFloats payload_offset = {};
  float payload_range[4] = {};            // [0], [1]: lowest and highest storable value; outside: stored invalid
  ChannelFloats free_payload = {};        // FrameUniforms::free_payload
};

enum class ResourceFormat {
  kRgba8Unorm, kRg16Unorm, kRgba16Unorm, kRg16Sfloat, kRgba16Sfloat, kRgba32Sfloat,
  kR32Uint, kRg32Uint, kRgba32Uint, kR8Unorm, kR16Sfloat, kR32Sfloat
};
const char* nameOf(ResourceFormat format);
std::optional<ResourceFormat> resourceFormatOf(const std::string& name);
int bytesPerPixel(ResourceFormat format);
bool isUint(ResourceFormat format);  // read with nearest filters only

// kFrame: content lives for one frame. kHistory: two images that swap roles every frame; attachments write this frame's,
// reads see last frame's unless they say `current`. kPersistent: one image that keeps its content through frames that do not write it;
// reads are meaningful in the frame after one that did.
enum class Lifetime { kFrame, kHistory, kPersistent };

struct Resource {
  std::string name;
  ResourceFormat format = ResourceFormat::kRgba16Sfloat;
  float scale = 1;  // of the target's extent
  Lifetime lifetime = Lifetime::kFrame;
  std::array<float, 4> clear = {0, 0, 0, 0};  // of UINT formats the bits: only 0 is of use
  bool operator==(const Resource&) const = default;
};

enum class LoadOp { kClear, kLoad, kDontCare };
enum class BlendKind { kReplace, kAdd };  // kAdd: one + one, for the counting copy

// Names of the resources that hold a payload: "cache", "cache1", ... by target, and its depth where that has an image of its own.
std::string payloadTarget(std::size_t target);
inline constexpr const char* kPayloadDepth = "cache_depth";
// Of counting copies: what each pixel shows, 0 uncovered, 1 hit, 2 miss, in a byte; or, as floats, the same and the payload's age in frames.
inline constexpr const char* kKind = "kind";
inline constexpr const char* kKindAndAge = "kind_and_age";

struct ColorAttachment {
  int app_target = -1;   // index of the application's colour target, or
  std::string resource;  // the name of a resource
  LoadOp load = LoadOp::kClear;
  BlendKind blend = BlendKind::kReplace;
  int location = 0;      // fragment output location
  bool operator==(const ColorAttachment&) const = default;
};

// Depth state of a pass. kAsApp: the application's comparison and write flag.
// kNone: neither tested nor written.
enum class DepthUse { kAsApp, kEqualNoWrite, kNone };
// Stencil state of a pass. kMarkIfZero: passes where 0, writes 1; the attachment's stencil is cleared to 0 at load.
enum class StencilUse { kNone, kMarkIfZero };

struct Read {
  std::string resource;
  std::uint32_t binding = 2;   // in reprise_set
  Filter filter = Filter::kNearest;  // samplers use unnormalized coordinates and clamp to edge
  bool current = false;        // this frame's image (written by an earlier rendering) instead of last frame's
  bool operator==(const Read&) const = default;
};

// The frames in which a pass draws, told by isWhollyDue. A rendering none of whose passes draws is left out with its clears.
enum class PassFrames { kAll, kWhollyDue, kNotWhollyDue };

// kDraw: the application's objects. kTiles: the player's own draw of a quad for each tile of the target, as a strip of 4 vertices for each
// instance; the vertex module makes nothing of the tiles that are not flagged. The application's sets and push constants are those that
// the last draw before it bound. kDispatch, kFullScreen: not played yet.
enum class PassKind { kDraw, kTiles, kDispatch, kFullScreen };

inline constexpr std::uint32_t kTilePixels = 16;  // edge of a tile
inline constexpr std::uint32_t kFlagsBinding = 15;

// Which of the application's objects a draw pass draws. kFlagged: those of which an earlier rendering has flagged a miss, told by the device
// itself (conditional rendering); it may be more, as fragments that something hides flag their object too.
enum class PassObjects { kAll, kFlagged };

struct Pass {
  std::string name;             // "lookup", "shade", ...: for time stamps and reports
  PassKind kind = PassKind::kDraw;
  int rendering = 0;            // passes of one rendering instance are consecutive
  std::string vertex_module;    // names of modules
  std::string fragment_module;  // empty: depth only
  std::vector<ColorAttachment> colors;  // the same list, in order, for all passes of a rendering
  bool depth_clear = true;      // of the rendering's first pass: clear (else load) depth and stencil
  DepthUse depth = DepthUse::kAsApp;
  StencilUse stencil = StencilUse::kNone;
  std::vector<Read> reads;
  PassFrames frames = PassFrames::kAll;
  PassObjects objects = PassObjects::kAll;
  bool operator==(const Pass&) const = default;
};

bool drawsIn(const Pass& pass, bool wholly_due);

struct ModuleEntry {
  std::string name;   // "fragment_hit"
  std::string stage;  // "vertex", "fragment", "compute"
  std::string hash;   // contentHash of its SPIR-V
  bool operator==(const ModuleEntry&) const = default;
};

enum class PreviousSource { kUniformBlock, kPushConstants };

// An input of the slice of gl_Position whose content of the last frame the player has to supply.
struct PreviousInput {
  PreviousSource source = PreviousSource::kUniformBlock;
  std::string name;             // of the block
  std::uint32_t set = 0;        // of the application's block; unused for push constants
  std::uint32_t binding = 0;
  std::uint32_t size_bytes = 0;
  std::uint32_t reprise_binding = 16;  // where the previous copy is bound; unused for push constants
  bool operator==(const PreviousInput&) const = default;
};

inline constexpr int kNoGuard = -1;

// One of the values that a payload is made of.
struct PayloadValue {
  std::string name;
  std::string type;  // "float", "ivec3"
  std::string file;
  int line = 0;
  int column = 0;
  int channels = 1;
  int first_channel = 0;            // of the payload's
  int guard_channel = kNoGuard;     // of a value in conditional code: the channel that holds 1 where it was computed, else 0
  std::array<float, 4> range_min = {};  // as seen in training; equal to range_max where not known
  std::array<float, 4> range_max = {};
  std::vector<std::string> inputs;      // what it depends on: "Scene.camera_position", "texture albedo", "varying normal"
  bool operator==(const PayloadValue&) const = default;
};

struct Requirements {
  bool stencil = false;                 // the depth target must have stencil
  bool depth_less_or_greater = false;   // strict comparison with depth writes
  bool independent_blend = false;
  bool linear_filter = false;           // of the history formats
  int color_attachments = 1;
  bool fragment_stores = false;         // fragmentStoresAndAtomics
  bool shared_inputs = false;           // what the fragment shader reads besides varyings is the same for all draws of a frame
  bool conditional_rendering = false;   // VK_EXT_conditional_rendering
  bool rejected_lanes_load = false;     // lanes that early tests reject load from storage buffers, for their neighbours' derivatives
  bool operator==(const Requirements&) const = default;
};

// What the misses of a frame are flagged by, for passes of kind kTiles or of kFlagged objects.
enum class MissFlagging { kNone, kTiles, kDraws };

// Whose image the history is. kOtherEye: the application draws left eye, right eye, left eye, right eye, ..., each pair at one
// moment; pattern whole at period 2 makes it compute every left eye and take what it can of the right one from there.
enum class PreviousImage { kLastFrame, kOtherEye };
const char* nameOf(PreviousImage previous);  // "frame", "other_eye"
std::optional<PreviousImage> previousImageOf(const std::string& name);

struct Recipe {
  int format_version = kRecipeFormatVersion;
  std::string strategy;   // "original", "branch", "two_pass", ...
  PatternKind pattern = PatternKind::kInterleaved;
  std::uint32_t block_pixels = 16;
  Filter filter = Filter::kNearest;
  Encoding encoding = Encoding::kRgba16f;
  std::uint32_t period_frames = 1;  // the chosen one; a run-time parameter all the same
  PreviousImage previous = PreviousImage::kLastFrame;
  std::vector<PayloadValue> payload;
  Requirements requirements;
  std::uint32_t reprise_set = 0;
  bool uses_reprise_set = true;     // false for the original
  MissFlagging flags = MissFlagging::kNone;
  bool orthographic = false;        // history depth is z instead of w
  CacheConstants constants;
  std::vector<Resource> resources;
  std::vector<Pass> passes;
  std::vector<ModuleEntry> modules;
  std::vector<PreviousInput> previous_inputs;
};

}  // namespace reprise
