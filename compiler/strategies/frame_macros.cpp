#include "compiler/strategies/frame_macros.h"

#include <fmt/format.h>

#include <bit>

#include "compiler/transforms/previous_position.h"

namespace reprise {
namespace {

// Nine digits give every float back.
std::string vec4Text(const float* values) {
  return fmt::format("vec4({:#.9g}, {:#.9g}, {:#.9g}, {:#.9g})", values[0], values[1], values[2], values[3]);
}

// A GLSL array with a vec4 for each target.
std::string targetsText(const ChannelFloats& values, std::size_t targets) {
  std::string text = "vec4[](";
  for (std::size_t target = 0; target < targets; ++target) text += (target == 0 ? "" : ", ") + vec4Text(&values[4 * target]);
  return text + ")";
}

// A GLSL expression over `texel` and `reprise_wanted`: every guard that is wanted holds. Filtered guards are 1 where all taps
// had the value; the margin is for the rounding of filters.
std::string guardsText(const FrameMacroSource& source) {
  std::string text = "true";
  for (const int guard : source.guards)
    text += fmt::format(" && ((reprise_wanted & {}u) == 0u || texel[{}].{} {})", 1u << guard, guard / 4, "xyzw"[guard % 4],
                        source.layout.integer ? "!= 0u" : ">= 0.998");
  return text;
}

// What lies in the payload where a guarded value was not computed: in range, so that it may be stored, and 0 for guards.
std::string initialText(const FrameMacroSource& source) {
  const std::size_t targets = source.layout.payload_formats.size();
  if (source.layout.integer) {
    std::string text = "uvec4[](uvec4(0)";
    for (std::size_t target = 1; target < targets; ++target) text += ", uvec4(0)";
    return text + ")";
  }
  ChannelFloats initial = source.constants.free_payload;
  for (const int guard : source.guards) initial[static_cast<std::size_t>(guard)] = 0;
  return targetsText(initial, targets);
}

}  // namespace

FrameMacros frameMacros(const FrameMacroSource& source) {
  const auto& [program, options, layout, constants, guards, scalar, keeps_raw_payload, reprise_set] = source;
  const std::size_t targets = layout.payload_formats.size();
  const auto flag = [](bool set) { return std::string(set ? "1" : "0"); };
  const auto number = [](auto value) { return std::to_string(value); };
  return {{"REPRISE_SET", number(reprise_set)},
          {"PREVIOUS_LOCATION", number(firstFreeVarying(program.vertex, program.fragment->module))},
          {"CACHE_LOCATION", "0"},
          {"COUNT_LOCATION", "0"},
          {"KEPT_LOCATION", "0"},
          {"TILE_PIXELS", number(kTilePixels)},
          {"FLAGS_BINDING", number(kFlagsBinding)},
          {"FLAGS_DRAWS", "0"},
          {"FRAG_COORD", "gl_FragCoord"},
          {"STORES", "1"},
          {"TARGETS", number(targets)},
          {"LAST_CHANNELS", number(layout.last_channels)},
          {"GUARDED", flag(!guards.empty())},
          {"GUARDS_HOLD", guardsText(source)},
          {"PAYLOAD_INITIAL", initialText(source)},
          {"PAYLOAD_VEC", layout.integer ? "uvec4" : "vec4"},
          {"PAYLOAD_SAMPLER", layout.integer ? "usampler2D" : "sampler2D"},
          {"INTEGER", flag(layout.integer)},
          {"SIGNED", flag(scalar == PayloadScalar::kInt)},
          {"NARROW", flag(layout.narrow)},
          {"DEPTH_IN_ALPHA", flag(layout.depth_in_alpha)},
          {"AFFINE", flag(layout.affine)},
          {"KEEP_RAW", flag(keeps_raw_payload)},
          {"TAKES_DERIVATIVES", flag(program.analysis.takes_derivatives)},
          {"ORTHOGRAPHIC", flag(options.orthographic)},
          {"BILINEAR", flag(options.filter == Filter::kBilinear)},
          {"INSTRUMENTED", flag(options.instrumented)},
          {"AGED", flag(options.instrumented && options.aged)},
          {"AGE_BINDING", "0"},
          {"POISONED", flag(options.poisoned)},
          {"BLOCK_SHIFT", number(std::countr_zero(options.block_pixels))},
          {"PATTERN_TILED", "0"},
          {"PATTERN_RANDOM", "1"},
          {"PATTERN_INTERLEAVED", "2"},
          {"PATTERN_WHOLE", "3"},
          {"PATTERN", number(static_cast<int>(options.pattern))},
          {"DEPTH_RANGE", vec4Text(constants.depth_range)},
          {"TOLERANCE", vec4Text(constants.tolerance)},
          {"PAYLOAD_SCALE", targetsText(constants.payload_scale, targets)},
          {"PAYLOAD_OFFSET", targetsText(constants.payload_offset, targets)},
          {"PAYLOAD_RANGE", vec4Text(constants.payload_range)}};
}

}  // namespace reprise
