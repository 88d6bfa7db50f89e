// Candidate x strategy x pattern x filter x encoding -> a recipe with its modules (stage 5).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compiler/candidates/enumerate.h"
#include "compiler/strategies/cache_layout.h"
#include "compiler/strategies/shader_program.h"
#include "compiler/strategies/strategy.h"
#include "runtime/package/recipe.h"

namespace reprise {

struct VariantOptions {
  std::string strategy = "two_pass";
  PatternKind pattern = PatternKind::kInterleaved;
  std::uint32_t block_pixels = 16;   // power of two, 2..256
  Filter filter = Filter::kBilinear;
  Encoding encoding = Encoding::kRgba16f;
  std::uint32_t period_frames = 8;
  PreviousImage previous = PreviousImage::kLastFrame;
  bool instrumented = false;         // the counting copy: resources "kind" and "counts"
  // Of the counting copy: "kind_and_age" in place of "kind". The age is the number of frames since the payload that a pixel shows was computed,
  // 255 for more. A miss has 0. A hit has one more than the texel nearest to where it was fetched, which a nearest fetch would take, also
  // where a filter mixes several. Frames are counted as they are recorded: of a pair of eyes the first has 0, and what the second takes from
  // it has 1. Pixels that are uncovered have no age.
  bool aged = false;
  bool poisoned = false;             // hits get wrong payloads: whether that shows tells whether a test of hits can
  bool orthographic = false;         // the camera's projection: history depth is z, else w
  ValueRanges ranges;
};

// What the application's state allows, by what it sets.
struct StateLimits {
  bool strict_depth_with_writes = true;  // LESS or GREATER
  bool stencil = false;
  bool shared_inputs = false;  // what the fragment shader reads besides varyings is the same for all draws of a frame
  bool several_draws = true;   // a frame has more than one
  // Of the device that is measured on: lanes that early tests reject load from storage buffers. Where no device is known, what is built says
  // what it needs (Requirements::rejected_lanes_load).
  bool rejected_lanes_load = true;
  std::string device;          // its name, for the refusal
};

struct BuiltRecipe {
  Recipe recipe;
  std::map<std::string, std::vector<std::uint32_t>> modules;  // stripped, valid; by name
};

// Errors (kRefused): shader.*, vertex.*, variable.use (see the transforms); state.depth_compare, state.no_stencil,
// device.rejected_lanes; state.targets, state.early_tests, state.computed_depth, state.shared_inputs, state.one_draw; repair.derivatives, repair.discards, repair.input;
// filter.integer (an integer payload with another filter than
// nearest); strategy.unknown (kInput). Every module has passed the validator: one that does not is our bug and reported as
// kRefused rewrite.invalid, so that a run goes on. `candidate` is not looked at by strategies that do not cache.
Result<BuiltRecipe> buildRecipe(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options,
                                const StateLimits& limits);

}  // namespace reprise
