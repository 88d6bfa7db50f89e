// write_seeds FOLDER: what the fuzz targets start from, in a folder of FOLDER for each, made of our own shaders, their variants and
// scenarios.
#include <iostream>
#include <nlohmann/json.hpp>
#include <regex>

#include "compiler/source/harness_vertex.h"
#include "compiler/strategies/build_package.h"
#include "runtime/base/file.h"
#include "tests/gltf/made_gltf.h"

namespace {

namespace fs = std::filesystem;
using namespace reprise;

constexpr std::size_t kCandidates = 2;

// Constructs that our shaders lack.
constexpr const char* kFragments[] = {
    R"(#version 450
layout(location = 0) in vec4 p;
layout(location = 0) out vec4 color;
void main() {
  float sum = 0.0;
  switch (int(p.x * 4.0)) {
    case 0: sum = sin(p.y); break;
    case 1: sum = cos(p.y);
    case 2: sum += exp(p.z); break;
    default: if (p.w > 0.5) { color = vec4(1.0); return; } sum = 3.0;
  }
  color = vec4(sum, sum * p.x, pow(sum, 2.0), 1.0);
}
)",
    R"(#version 450
layout(location = 0) in vec3 p;
layout(location = 1) flat in int n;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Scene { mat4 m; vec4 lights[4]; float gain; } scene;
struct Surface { vec3 normal; float rough; };
Surface at(vec3 q) { return Surface(normalize(mat3(scene.m) * q), fract(q.x)); }
void main() {
  float table[8];
  for (int i = 0; i < 8; ++i) table[i] = sin(float(i) * p.x);
  Surface s = at(p);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < n; ++i) {
    if (dot(s.normal, scene.lights[i & 3].xyz) < 0.0) continue;
    for (int k = 0; k < 3; ++k) sum += scene.lights[i & 3].rgb * pow(s.rough, float(k));
    if (sum.x > 10.0) break;
  }
  color = vec4(sum * scene.gain, table[n & 7]);
}
)",
    R"(#version 450
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 1) out uvec2 ids;
layout(set = 1, binding = 2) uniform sampler2D albedo;
layout(push_constant) uniform Push { vec2 offset; uint seed; } push;
float noise(vec2 q) { uint h = floatBitsToUint(q.x) * 747796405u ^ push.seed; return float(h >> 9) / 8388608.0; }
void main() {
  vec4 texel = texture(albedo, uv + push.offset);
  if (texel.a < 0.1) discard;
  bool inside = length(uv) < 1.0;
  float n = noise(uv) + noise(uv * 2.0) + noise(uv * 4.0);
  color = inside ? texel * n : vec4(dFdx(uv.x), textureLod(albedo, uv, 2.0).rg, 1.0);
  ids = uvec2(uint(n * 100.0), push.seed);
  gl_FragDepth = gl_FragCoord.z * 0.5 + 0.1 * n;
}
)"};

constexpr const char* kScenario = R"(name = "all"
[shader]
fragment = "a.frag"
vertex = "a.vert"
include_dirs = ["common"]
defines = { LAYERS = 4, NAME = "x", ON = true }
[render]
width = 64
height = 48
frames = 8
frame_time_s = 0.02
periods = [1, 2, "never"]
seed = 7
cull = "none"
depth_compare = "less"
depth_stencil = true
formats = ["rgba16_sfloat"]
clear = [0, 0.5, 1, 1]
tone_map = "aces"
exposure = 1.5
[[object]]
name = "ball"
mesh = { kind = "sphere", radius = 1.5, segments_u = 16, segments_v = 8 }
motion = { translate = [0, 1, 0], rotate_deg = { random_walk = { base = [0, 0, 0], extent = [1, 2, 3], step_per_s = 2, seed = 3 } }, scale = 2 }
[[object]]
name = "knot"
mesh = { kind = "torus_knot", radius = 1, tube_radius = 0.2, p = 2, q = 5 }
motion = { spin_axis = [1, 0, 0], spin_rad_per_frame = 0.1 }
[[object]]
name = "vase"
mesh = { kind = "revolution", profile = [[0, 0], [1, 0.5], [0.5, 1]] }
[[object]]
name = "hills"
mesh = { kind = "terrain", size = 4, height = 0.5, seed = 9 }
[uniforms]
"Scene.view_projection" = "view_projection"
Scene.gain = { oscillate = { base = 1, amplitude = 0.5, period_s = 2, phase_rad = 1 } }
"Scene.tint" = { key_frames = [{ at_s = 0, value = [1, 0, 0] }, { at_s = 1, value = [0, 1, 0] }] }
[[texture]]
name = "wood"
file = "wood.png"
srgb = true
[[texture]]
name = "noise"
kind = "noise"
size = 64
cells = 4
seed = 5
color_a = [1, 1, 1, 1]
linear = false
[[session]]
name = "train"
role = "training"
camera = { orbit = { target = [0, 0, 0], radius = 3, height = 1, start_rad = 0.5, radians_per_frame = 0.01 }, fov_y_deg = 60, near = 0.5, far = 50 }
frames = 12
speed = 0.5
motions.ball = { translate = [0, 0, 1] }
uniforms."Scene.gain" = 2
[[session]]
name = "check"
role = "validation"
camera = { eye = [0, 1, 4], target = { value = [0, 0, 0] }, up = [0, 1, 0], orthographic = true, ortho_height = 3 }
uniforms."Scene.gain" = { flicker = { base = 1, amplitude = 0.5, rate_hz = 12, seed = 3 } }
[[session]]
name = "walk"
role = "validation"
camera = { recorded = [[0, 1, 2, 3, 0, 0, 0, 1, 45], [0.5, 1, 2, 4, 0, 0.6, 0, 0.8, 50]], handheld = { move = 0.01, turn_deg = 0.3, frequency_hz = 2, seed = 1 }, cuts = [{ at_s = 0.7, turn_deg = 60, move = [1, 0, 0] }] }
)";

class SeedWriter {
 public:
  explicit SeedWriter(fs::path folder) : folder_(std::move(folder)) {}

  void shader(const CompiledShader& shader) {
    for (const char* kind : {"spirv_reader", "rewriter"}) write(kind, bytesOf(shader.words));
    if (shader.stage == ShaderStage::kFragment) variants(shader);
  }

  void model(const MadeParts& parts) { write("gltf_reader", madeGltf(parts).dump()); }

  void scenario(const std::string& text) {
    write("scenario_reader", std::regex_replace(std::regex_replace(text, std::regex(R"("[^"]*\.frag")"), "\"a.frag\""),
                                         std::regex(R"("[^"]*\.vert")"), "\"a.vert\""));
  }

 private:
  void variants(const CompiledShader& fragment) {
    const Result<std::string> vertex_text = harnessVertexText(fragment.words);
    if (!vertex_text.ok()) return;
    CompileOptions options;
    options.stage = ShaderStage::kVertex;
    const CompiledShader vertex = compileText(*vertex_text, "harness.vert", options).value();
    const ShaderProgram program = readProgram(vertex, fragment).value();
    CandidateOptions enumeration;
    enumeration.most = kCandidates;
    for (const Candidate& candidate :
         enumerateCandidates(*program.fragment, program.analysis, program.sources, enumeration)) {
      if (!candidate.kept()) continue;
      for (const Strategy& strategy : strategies()) {
        VariantOptions variant;
        variant.strategy = strategy.name;
        variant.filter = isInteger(candidate.scalar) ? Filter::kNearest : Filter::kBilinear;
        const Result<Package> package = buildPackage(program, candidate, variant, {true, true, true});
        if (!package.ok()) continue;
        for (const auto& [name, words] : package->modules) write("spirv_reader", bytesOf(words));
        const fs::path scratch = folder_ / "scratch";
        if (!writePackageFiles(*package, scratch).ok()) continue;
        write("manifest_reader", nlohmann::json::parse(readFile(scratch / "manifest.json").value()).at("package").dump());
        write("manifest_reader", recipeToJson(package->variant));
        fs::remove_all(scratch);
      }
    }
    write("manifest_reader", interfaceToJson(program.interface));
  }

  void write(const std::string& kind, std::string_view bytes) {
    const Result<void> written = writeFile(folder_ / kind / ("seed" + std::to_string(count_++)), bytes);
    REPRISE_CHECK(written.ok(), written.error().message);
  }

  fs::path folder_;
  int count_ = 0;
};

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: write_seeds FOLDER\n";
    return 2;
  }
  SeedWriter seeds(arguments[1]);
  for (const char* text : kFragments) seeds.shader(compileText(text, "seed.frag", {}).value());
  seeds.scenario(kScenario);
  for (const char* interpolation : {"LINEAR", "STEP", "CUBICSPLINE"}) seeds.model({true, true, true, interpolation, 2});
  seeds.model({false, false, false, "LINEAR", 0});
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(REPRISE_SOURCE_DIR) / "shaders")) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".frag" || extension == ".vert") seeds.shader(compile(entry.path(), {}).value());
    if (extension == ".toml") seeds.scenario(readFile(entry.path()).value());
  }
  return 0;
}
