// A scenario as plain values: the shader, what it draws, what its inputs are and how they vary. Read from TOML by
// readScenario (read_scenario.h); the format is documented in docs/scenario.md.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "profiler/gltf/gltf_scene.h"
#include "profiler/scenario/camera_path.h"
#include "runtime/base/result.h"

namespace reprise {

// A value over time: 1 to 256 floats, as many at every time. Times are in seconds, angles in radians, unless the name says
// otherwise. Matrices are given column by column.
struct FixedTrack {
  std::vector<float> value;
  bool operator==(const FixedTrack&) const = default;
};
struct KeyFramesTrack {  // piecewise linear, clamped at the ends; times_s rise strictly
  std::vector<float> times_s;
  std::vector<std::vector<float>> values;
  bool operator==(const KeyFramesTrack&) const = default;
};
struct OscillationTrack {  // base + amplitude * sin(2 pi t / period_s + phase_rad)
  std::vector<float> base, amplitude;
  float period_s = 1;
  float phase_rad = 0;
  bool operator==(const OscillationTrack&) const = default;
};
// Seeded; starts at base, each component stays within base +- extent and moves by at most step_per_s in a second.
struct RandomWalkTrack {
  std::vector<float> base, extent;
  float step_per_s = 1;
  std::uint32_t seed = 1;
  bool operator==(const RandomWalkTrack&) const = default;
};
// base + amplitude * u, where u in [-1, 1) is drawn anew rate_hz times a second and is the same for all components, as a lamp
// flickers as one. Seeded.
struct FlickerTrack {
  std::vector<float> base, amplitude;
  float rate_hz = 12;
  std::uint32_t seed = 1;
  bool operator==(const FlickerTrack&) const = default;
};
using Track = std::variant<FixedTrack, KeyFramesTrack, OscillationTrack, RandomWalkTrack, FlickerTrack>;

// Around target in the plane normal to up, height above it. With up = +y: at +z for angle 0, at +x a quarter turn later.
struct OrbitPath {
  std::array<float, 3> target = {0, 0, 0};
  float radius = 4;
  float height = 0;
  float start_rad = 0;
  float radians_per_frame = 0.02f;
  bool operator==(const OrbitPath&) const = default;
};
struct TrackPath {
  Track eye;     // 3 values
  Track target;  // 3 values
  bool operator==(const TrackPath&) const = default;
};
using CameraPath = std::variant<OrbitPath, TrackPath, RecordedPath, ModelCameraPath>;

struct Camera {
  CameraPath path;
  std::array<float, 3> up = {0, 1, 0};
  bool orthographic = false;
  float fov_y_deg = 45;       // perspective
  float ortho_height = 4;     // orthographic: height of the view volume
  float near_plane = 0.1f, far_plane = 100;  // far: infinity where perspective
  bool reverse_z = false;
  std::optional<Handheld> handheld = {};
  std::vector<CameraCut> cuts = {};  // times rise strictly
  bool operator==(const Camera&) const = default;
};

// Position, rotation and scale of an object over time. rotation: Euler angles in degrees, applied x, then y, then z.
// translate and scale: 3 values; spin: constant turn about `spin_axis`.
struct Motion {
  Track translate = FixedTrack{{0, 0, 0}};
  Track rotate_deg = FixedTrack{{0, 0, 0}};
  Track scale = FixedTrack{{1, 1, 1}};
  std::array<float, 3> spin_axis = {0, 1, 0};
  float spin_rad_per_frame = 0;
  bool operator==(const Motion&) const = default;
};

enum class MeshKind { kSphere, kTorusKnot, kPlane, kTerrain, kRevolution, kDisplacedSphere };

struct MeshSpec {
  MeshKind kind = MeshKind::kSphere;
  int segments_u = 64, segments_v = 32;
  float radius = 1;                 // sphere, displaced sphere, knot
  float tube_radius = 0.3f;         // knot
  int p = 2, q = 3;                 // knot
  float size = 2;                   // plane, terrain: edge length
  float height = 0.3f;              // terrain; displaced sphere: most displacement, in radii
  int cells = 8;                    // displaced sphere: lattice cells around the equator
  std::uint32_t seed = 1;           // terrain, displaced sphere
  std::vector<std::array<float, 2>> profile;  // revolution: (radius, y) from bottom to top, a smooth curve through them
  bool operator==(const MeshSpec&) const = default;
};

// Which primitive of which model an object draws: indices into Scenario::models and GltfScene::instances.
struct ModelPart {
  std::size_t model = 0, instance = 0;
  bool operator==(const ModelPart&) const = default;
};

struct Object {
  std::string name;
  MeshSpec mesh;
  Motion motion;
  std::optional<ModelPart> part = {};  // of a model, instead of mesh and motion
  bool operator==(const Object&) const = default;
};

// A glTF file, or a made-up figure. Its primitives are objects of the scenario, named "model.0", "model.1", ...
struct ModelSpec {
  std::string name;
  std::string path;            // absolute; empty: the figure
  int segments = 12;           // of the figure's capsules
  std::optional<std::string> animation;  // by name; none: the first; "": the pose at rest
  float speed = 1;             // of the animation
  float phase_s = 0;           // how far the animation is at the start
  std::array<float, 4> color = {1, 1, 1, 1};  // times the materials' base colour
  Motion motion;
  Place place;
  std::shared_ptr<const GltfScene> scene;  // what was read; not compared

  bool operator==(const ModelSpec& other) const {
    return name == other.name && path == other.path && segments == other.segments && animation == other.animation &&
           speed == other.speed && phase_s == other.phase_s && color == other.color && motion == other.motion && place == other.place;
  }
};

enum class Semantic {
  kView, kProjection, kViewProjection, kModel, kNormalMatrix, kCameraPosition, kTime, kFrame, kResolution,
  kShadowViewProjection,  // of the light of the shadow pass `shadow_map`
  // Of models; of other objects as for the unit material, no joints, no morphing, no lights.
  kJointMatrices, kJointCount, kMorphWeights, kBaseColorFactor, kMetallicRoughness, kEmissiveFactor, kAlphaCutoff,
  kLightPosition, kLightColor, kLightDirection, kLightCount
};

// kView, kProjection, kViewProjection or kCameraPosition as a pass sees the scene: that of its light, or the camera's.
struct PassSource {
  std::string pass;
  Semantic semantic = Semantic::kViewProjection;
  bool operator==(const PassSource&) const = default;
};

// Where a uniform member's value comes from. "block.member" names it in `UniformBinding::member`.
struct UniformBinding {
  std::string member;
  std::variant<Semantic, Track, PassSource> source;
  Place place;
  bool operator==(const UniformBinding&) const = default;
};

enum class TextureKind { kFile, kChecker, kNoise, kGradient, kSky, kBumps, kDiscs };

struct TextureSpec {
  std::string name;     // the descriptor's name in the shader
  TextureKind kind = TextureKind::kChecker;
  std::string path;     // kFile: PNG or HDR, absolute
  int size = 256;       // generated: width and height
  int cells = 8;
  std::uint32_t seed = 1;
  std::array<float, 4> color_a = {1, 1, 1, 1}, color_b = {0, 0, 0, 1};
  float height = 0.1f;  // bumps: of the highest, in cells
  std::vector<std::string> objects;       // discs: whose surfaces they stand for, a row each
  int discs_u = 4, discs_v = 4;           // discs: around and along each object's surface
  bool object_space = false;              // discs: as the mesh lies; else as the object lies at time 0
  bool linear = true;   // filter
  bool repeat = true;
  bool mipmaps = true;
  bool srgb = false;
  Place place;
  Place file_place;     // kFile: where the file is named
  bool operator==(const TextureSpec&) const = default;
};

enum class ScenePassKind { kShadow, kGBuffer };

struct PassOutput {
  std::string texture;                   // by which shaders know it
  std::string format = "rgba16_sfloat";  // as in RenderState::color_formats
  bool linear = false;                   // filter
  bool operator==(const PassOutput&) const = default;
};

// What is rendered before the shader in every frame, for it and for later passes to read.
struct PassSpec {
  std::string name;                      // of a shadow pass: of its texture, too
  ScenePassKind kind = ScenePassKind::kShadow;
  // kShadow: the depth of the objects as the light sees them, `size` texels square.
  Camera light;
  std::array<float, 3> color = {3, 3, 3};  // what the light of the standard shader emits
  std::uint32_t size = 1024;
  float slope_bias = 2;
  std::vector<std::string> objects;      // of objects and models; empty: all
  // kGBuffer: all objects with shaders of its own, as the camera sees them and at the render's size.
  std::string fragment_path, vertex_path;  // absolute; no vertex shader: the scenario's
  std::string package;                   // directory of the compiled pair; copyInputs makes it
  std::vector<PassOutput> outputs;
  std::string depth_texture;             // empty: its depth is not read
  Place place;
  bool operator==(const PassSpec&) const = default;
};

enum class CullMode { kNone, kBack, kFront };
enum class DepthCompare { kLess, kLessOrEqual, kGreater, kGreaterOrEqual };

struct RenderState {
  CullMode cull = CullMode::kBack;
  DepthCompare compare = DepthCompare::kLess;
  bool depth_stencil = false;             // D32_SFLOAT_S8_UINT instead of D32_SFLOAT
  // "rgba8_unorm", "rgba16_sfloat", "rgba32_sfloat", one per output; empty: rgba8_unorm for every output.
  std::vector<std::string> color_formats;
  std::array<float, 4> clear = {0, 0, 0, 1};
  bool operator==(const RenderState&) const = default;
};

// Frames alternate between two eyes with parallel axes: frame 2k is the left eye of moment k, frame 2k + 1 the right one.
struct Stereo {
  float eye_distance = 0.06f;  // in units of the world: half of it to the left and to the right of the camera
  bool operator==(const Stereo&) const = default;
};

enum class SessionRole { kTraining, kValidation };

// One path through the scenario. Objects and uniforms not overridden move as the scenario says. speed scales time and all
// motion per frame; 0 freezes all.
struct SessionSpec {
  std::string name;
  SessionRole role = SessionRole::kTraining;
  Camera camera;
  int frames = 0;       // 0: the scenario's
  float speed = 1;
  std::map<std::string, Motion> motions;      // by object name
  std::map<std::string, Track> uniforms;      // by "block.member"
  bool operator==(const SessionSpec&) const = default;
};

enum class ToneMap { kNone, kReinhard, kAces };

// Where a pixel's surface was in the last frame: where the vertex shader put it then; or, by the user's word, where the pixel is, as what
// the shader draws stands still in the image.
enum class MotionSource { kVertex, kNone };

struct Scenario {
  std::string path;                 // of the TOML file, absolute
  std::string name;
  MotionSource motion = MotionSource::kVertex;
  std::string fragment_path, vertex_path;  // absolute; empty: the standard shaders
  std::string fragment_entry_point = "main", vertex_entry_point = "main";  // of SPIR-V and HLSL
  std::vector<std::pair<std::string, std::string>> vertex_inputs;  // a name in the shader, what meshes call it
  std::vector<std::string> include_dirs;
  std::vector<std::pair<std::string, std::string>> defines;
  std::uint32_t width = 640, height = 360;
  int frames = 96;                  // images; in stereo two of them are one moment
  float frame_time_s = 1.0f / 60;   // virtual time per frame; in stereo per moment
  std::optional<Stereo> stereo;     // periods are 1 and 2 then
  std::vector<std::uint32_t> periods = {1, 2, 4, 8, 16, 32, 64};  // kNeverRefresh (0) stands for never
  std::uint32_t seed = 1;           // mixed into the seeds of all tracks and shakes
  std::vector<ModelSpec> models;
  std::vector<Object> objects;      // those of the models after the others
  std::vector<UniformBinding> uniforms;
  Place uniforms_place;             // of [uniforms]; of the file where there is none
  std::vector<TextureSpec> textures;
  std::vector<PassSpec> passes;     // in the order in which they are rendered
  RenderState state;
  std::vector<SessionSpec> sessions;
  ToneMap tone_map = ToneMap::kNone;
  float exposure = 1;
  // contentHash of what the file says and of the texture files that it names. Comments, layout, the name and where files
  // lie are left out, so that a copy made by writeScenario has the same hash; the shaders' code has hashes of its own.
  std::string hash;
  bool operator==(const Scenario&) const = default;
};

}  // namespace reprise
