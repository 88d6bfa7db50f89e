#include "tests/runtime/small_recipes.h"

#include "compiler/source/compile.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

constexpr const char* kQuadVertex = R"(
layout(push_constant) uniform Draw { vec4 rect; vec4 place; } draw;
layout(location = 0) flat out vec4 value;
void main() {
  const vec2 corners[6] = vec2[](vec2(0, 0), vec2(1, 0), vec2(0, 1), vec2(0, 1), vec2(1, 0), vec2(1, 1));
  gl_Position = vec4(mix(draw.rect.xy, draw.rect.zw, corners[gl_VertexIndex]), draw.place.x, 1);
  value = vec4(draw.place.y, draw.place.z, draw.place.x, 1);
}
)";

constexpr const char* kPreviousVertex = R"(
layout(push_constant) uniform Draw { vec4 rect; vec4 place; } draw;
layout(set = 0, binding = 0, std140) uniform Object { vec4 value; } object;
layout(set = 2, binding = 1, std140) uniform RepriseDraw {
  uint valid_last_frame;
  layout(offset = 16) vec4 rect;
  layout(offset = 32) vec4 place;
} last;
layout(set = 2, binding = 16, std140) uniform Previous { vec4 value; } previous;
layout(location = 0) flat out vec4 value;
void main() {
  const vec2 corners[6] = vec2[](vec2(0, 0), vec2(1, 0), vec2(0, 1), vec2(0, 1), vec2(1, 0), vec2(1, 1));
  gl_Position = vec4(mix(draw.rect.xy, draw.rect.zw, corners[gl_VertexIndex]), draw.place.x, 1);
  value = vec4(last.valid_last_frame, last.place.y, draw.place.y, previous.value.x + 0.0 * object.value.x);
}
)";

constexpr const char* kValueFragment = R"(
layout(location = 0) flat in vec4 value;
layout(location = 0) out vec4 color;
void main() { color = value; }
)";

constexpr const char* kFrameBlock = R"(
layout(set = 0, binding = 0, std140) uniform RepriseFrame {
  uint frame; uint period_frames; uint history_valid; uint unused; vec4 viewport; vec4 previous_viewport;
} reprise;
)";

std::vector<std::uint32_t> compiled(const std::string& text, ShaderStage stage) {
  CompileOptions options;
  options.stage = stage;
  const Result<CompiledShader> shader = compileText("#version 450\n" + text, "small", options);
  REPRISE_CHECK(shader.ok(), formatError(shader.error()));
  return shader->words;
}

Pass drawPass(const std::string& fragment) {
  Pass pass;
  pass.name = fragment.empty() ? "depth" : fragment;
  pass.vertex_module = "vertex";
  pass.fragment_module = fragment;
  if (!fragment.empty()) pass.colors = {{0, "", LoadOp::kClear, BlendKind::kReplace, 0}};
  return pass;
}

void addModule(Package& package, const std::string& name, const std::string& text) {
  const bool is_vertex = name.starts_with("vertex");
  package.modules[name] = compiled(text, is_vertex ? ShaderStage::kVertex : ShaderStage::kFragment);
  const ModuleEntry entry{name, is_vertex ? "vertex" : "fragment", contentHash(bytesOf(package.modules[name]))};
  package.original.modules.push_back(entry);
  package.variant.modules.push_back(entry);
}

// A variant of one pass with a fragment shader of its own, which the caller completes.
Package cachingPackage(const std::string& fragment) {
  Package package = originalPackage();
  addModule(package, "cached", fragment);
  package.variant.strategy = "small";
  package.variant.uses_reprise_set = true;
  package.variant.passes = {drawPass("cached")};
  return package;
}

}  // namespace

Package originalPackage() {
  Package package;
  package.interface.outputs = {{"color", 0, ScalarKind::kFloat, 4}};
  for (Recipe* recipe : {&package.original, &package.variant}) {
    recipe->strategy = "original";
    recipe->uses_reprise_set = false;
    recipe->passes = {drawPass("original")};
  }
  addModule(package, "vertex", kQuadVertex);
  addModule(package, "original", kValueFragment);
  return package;
}

Package prepassPackage() {
  Package package = originalPackage();
  Pass shade = drawPass("original");
  shade.rendering = 1;
  shade.depth_clear = false;
  shade.depth = DepthUse::kEqualNoWrite;
  package.variant.passes = {drawPass(""), shade};
  return package;
}

Package accumulatingPackage() {
  Package package = cachingPackage(std::string(kFrameBlock) + R"(
layout(set = 0, binding = 2) uniform sampler2D cache;
layout(location = 0) out vec4 color;
layout(location = 2) out vec4 cache_out;
void main() {
  vec4 last = reprise.history_valid != 0u ? textureLod(cache, gl_FragCoord.xy, 0.0) : vec4(0);
  color = cache_out = last + vec4(1);
}
)");
  Recipe& recipe = package.variant;
  recipe.resources = {{"cache", ResourceFormat::kRgba32Sfloat, 1, Lifetime::kHistory, {0, 0, 0, 0}}};
  recipe.passes[0].colors.push_back({-1, "cache", LoadOp::kClear, BlendKind::kReplace, 2});
  recipe.passes[0].reads = {{"cache", 2, Filter::kNearest, false}};
  recipe.payload = {{"noise", "vec4", "small", 1, 1, 4, 0, kNoGuard, {}, {}, {"Scene.light", "texture albedo"}}};
  return package;
}

Package uniformsPackage() {
  return cachingPackage(std::string(kFrameBlock) + R"(
layout(location = 0) out vec4 color;
void main() { color = vec4(reprise.frame, reprise.period_frames, reprise.history_valid, reprise.previous_viewport.z); }
)");
}

Package previousPackage() {
  Package package = cachingPackage(kValueFragment);
  addModule(package, "vertex_previous", kPreviousVertex);
  package.variant.passes[0].vertex_module = "vertex_previous";
  package.variant.reprise_set = 2;
  package.variant.previous_inputs = {{PreviousSource::kPushConstants, "Draw", 0, 0, 32, 16},
                                     {PreviousSource::kUniformBlock, "Object", 0, 0, 16, 16}};
  return package;
}

Package twoRenderingsPackage() {
  Package package = cachingPackage(R"(
layout(set = 0, binding = 2) uniform sampler2D mid;
layout(location = 0) out vec4 color;
void main() { color = 10.0 * textureLod(mid, gl_FragCoord.xy, 0.0); }
)");
  Recipe& recipe = package.variant;
  recipe.resources = {{"mid", ResourceFormat::kRgba32Sfloat, 1, Lifetime::kFrame, {0, 0, 0, 0}}};
  Pass shade = recipe.passes[0];
  shade.rendering = 1;
  shade.depth_clear = false;
  shade.depth = DepthUse::kEqualNoWrite;
  shade.reads = {{"mid", 2, Filter::kNearest, true}};
  Pass slice = drawPass("original");
  slice.colors = {{-1, "mid", LoadOp::kClear, BlendKind::kReplace, 0}};
  recipe.passes = {slice, shade};
  return package;
}

Package countingPackage() {
  Package package = cachingPackage(R"(
layout(location = 0) out vec4 color;
layout(location = 1) out vec4 counts;
void main() { color = vec4(0.5); counts = vec4(1, 2, 0, 0); }
)");
  package.variant.resources = {{"counts", ResourceFormat::kRgba32Sfloat, 1, Lifetime::kFrame, {0, 0, 0, 0}}};
  package.variant.passes[0].colors.push_back({-1, "counts", LoadOp::kClear, BlendKind::kAdd, 1});
  package.variant.requirements.independent_blend = true;
  package.variant.requirements.color_attachments = 2;
  return package;
}

Package stencilPackage() {
  Package package = cachingPackage(kValueFragment);
  package.variant.passes[0].stencil = StencilUse::kMarkIfZero;
  package.variant.requirements.stencil = true;
  return package;
}

Package flaggedPackage() {
  Package package = cachingPackage(R"(
layout(set = 0, binding = 1, std140) uniform RepriseDraw { uint valid_last_frame; uint index; } draw;
layout(set = 0, binding = 15, std430) buffer RepriseFlags { uint flags[]; };
layout(location = 0) flat in vec4 value;
layout(location = 0) out vec4 color;
void main() {
  if (value.x > 4.0) atomicOr(flags[draw.index], 1u);
  color = vec4(0.5, 0.5, 0.5, 1.0);
}
)");
  Recipe& recipe = package.variant;
  recipe.flags = MissFlagging::kDraws;
  recipe.requirements.fragment_stores = recipe.requirements.conditional_rendering = true;
  Pass again = drawPass("original");
  again.rendering = 1;
  again.depth_clear = false;
  again.depth = DepthUse::kEqualNoWrite;
  again.objects = PassObjects::kFlagged;
  recipe.passes.push_back(again);
  return package;
}

}  // namespace reprise
