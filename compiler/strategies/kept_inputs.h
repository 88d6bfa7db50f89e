// What a fragment that missed leaves for the pass that repairs it: all that the shader reads of its triangle, bit by bit, as words of
// 32 bits in images of the target's size.
//
//   word 0          FragCoord.w, which is never 0: 0 stands for a pixel that needs no repair
//   then            FragCoord.z, where the shader reads FragCoord or depth is taken from it (orthographic cameras)
//   then            the shader's inputs, component by component, columns of matrices in turn
//   last            FrontFacing, where it is read
//
// FragCoord.xy is the pixel itself. What neighbours compute cannot be kept: shaders that take derivatives are refused elsewhere.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/transforms/link_frame.h"
#include "runtime/base/result.h"
#include "runtime/package/recipe.h"

namespace reprise {

enum class KeptScalar { kFloat, kInt, kUint };

struct KeptInput {
  std::uint32_t variable = 0;  // id in the shader's module
  std::string layout;          // GLSL: "layout(location = 2, component = 1) flat in "
  std::string type;            // "vec3", "int", "mat2x3"
  KeptScalar scalar = KeptScalar::kFloat;
  int rows = 1, columns = 1;
};

struct KeptInputs {
  std::vector<KeptInput> inputs;
  std::uint32_t frag_coord = 0;    // variables; 0: not read
  std::uint32_t front_facing = 0;
  bool keeps_depth = false;
};

// The inputs that functions of `module` refer to. Error (kRefused): repair.input, for inputs that are not kept: built-ins other than
// FragCoord, FrontFacing and HelperInvocation, arrays, structures, components of 16 or 64 bits, and inputs that are interpolated
// elsewhere than at the pixel's centre by an instruction.
Result<KeptInputs> keptInputs(const Module& module, bool orthographic);

std::size_t keptWords(const KeptInputs& kept);

// Of the images "kept", "kept1", ...: four words each, the last as narrow as it can be.
std::vector<ResourceFormat> keptFormats(const KeptInputs& kept);
std::string keptTarget(std::size_t target);

// KEPT_TARGETS, KEPT_GIVEN, KEEP, KEPT_TAKEN, TAKE of glsl/keep.glsl and kept.glsl.
std::map<std::string, std::string> keptMacros(const KeptInputs& kept);

// For the pass that keeps: inputs that the body reads, too, are the frame's. For the pass that repairs: the body's inputs are the
// frame's variables. `body`: the module to be linked, which may lack inputs that it does not read.
void bindGivenInputs(const KeptInputs& kept, const Module& body, FrameBindings& bindings);
void bindTakenInputs(const KeptInputs& kept, const Module& body, FrameBindings& bindings);

}  // namespace reprise
