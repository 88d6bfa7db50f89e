// How the choices of a scenario are spelled in TOML; one table each, for reading and for writing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "profiler/scenario/scenario.h"

namespace reprise {

template <typename T>
struct NameWithValue {
  const char* name;
  T value;
};

inline constexpr NameWithValue<MeshKind> kMeshKinds[] = {{"sphere", MeshKind::kSphere},
                                                      {"torus_knot", MeshKind::kTorusKnot},
                                                      {"plane", MeshKind::kPlane},
                                                      {"terrain", MeshKind::kTerrain},
                                                      {"revolution", MeshKind::kRevolution},
                                                      {"displaced_sphere", MeshKind::kDisplacedSphere}};

inline constexpr NameWithValue<Semantic> kSemantics[] = {{"view", Semantic::kView},
                                                      {"projection", Semantic::kProjection},
                                                      {"view_projection", Semantic::kViewProjection},
                                                      {"model", Semantic::kModel},
                                                      {"normal_matrix", Semantic::kNormalMatrix},
                                                      {"camera_position", Semantic::kCameraPosition},
                                                      {"time", Semantic::kTime},
                                                      {"frame", Semantic::kFrame},
                                                      {"resolution", Semantic::kResolution},
                                                      {"shadow_view_projection", Semantic::kShadowViewProjection},
                                                      {"joint_matrices", Semantic::kJointMatrices},
                                                      {"joint_count", Semantic::kJointCount},
                                                      {"morph_weights", Semantic::kMorphWeights},
                                                      {"base_color_factor", Semantic::kBaseColorFactor},
                                                      {"metallic_roughness", Semantic::kMetallicRoughness},
                                                      {"emissive_factor", Semantic::kEmissiveFactor},
                                                      {"alpha_cutoff", Semantic::kAlphaCutoff},
                                                      {"light_position", Semantic::kLightPosition},
                                                      {"light_color", Semantic::kLightColor},
                                                      {"light_direction", Semantic::kLightDirection},
                                                      {"light_count", Semantic::kLightCount}};

inline constexpr NameWithValue<TextureKind> kTextureKinds[] = {{"file", TextureKind::kFile},
                                                            {"checker", TextureKind::kChecker},
                                                            {"noise", TextureKind::kNoise},
                                                            {"gradient", TextureKind::kGradient},
                                                            {"sky", TextureKind::kSky},
                                                            {"bumps", TextureKind::kBumps},
                                                            {"discs", TextureKind::kDiscs}};

inline constexpr bool hasSeed(TextureKind kind) { return kind == TextureKind::kNoise || kind == TextureKind::kBumps; }
inline constexpr bool hasCells(TextureKind kind) { return kind == TextureKind::kChecker || hasSeed(kind); }

inline constexpr NameWithValue<ScenePassKind> kScenePassKinds[] = {{"shadow", ScenePassKind::kShadow}, {"gbuffer", ScenePassKind::kGBuffer}};

// Keys of uniform sources such as { pass_view_projection = "shadow_map" }.
inline constexpr NameWithValue<Semantic> kPassSources[] = {{"pass_view_projection", Semantic::kViewProjection},
                                                        {"pass_view", Semantic::kView},
                                                        {"pass_projection", Semantic::kProjection},
                                                        {"pass_position", Semantic::kCameraPosition}};

inline constexpr NameWithValue<CullMode> kCullModes[] = {
    {"none", CullMode::kNone}, {"back", CullMode::kBack}, {"front", CullMode::kFront}};

inline constexpr NameWithValue<DepthCompare> kDepthCompares[] = {
    {"less", DepthCompare::kLess},
    {"less_or_equal", DepthCompare::kLessOrEqual},
    {"greater", DepthCompare::kGreater},
    {"greater_or_equal", DepthCompare::kGreaterOrEqual}};

inline constexpr NameWithValue<SessionRole> kSessionRoles[] = {{"training", SessionRole::kTraining},
                                                            {"validation", SessionRole::kValidation}};

inline constexpr NameWithValue<ToneMap> kToneMaps[] = {
    {"none", ToneMap::kNone}, {"reinhard", ToneMap::kReinhard}, {"aces", ToneMap::kAces}};

inline constexpr const char* kColorFormats[] = {"rgba8_unorm", "rgba16_sfloat", "rgba32_sfloat"};

inline constexpr NameWithValue<MotionSource> kMotionSources[] = {{"vertex", MotionSource::kVertex}, {"none", MotionSource::kNone}};

// Limits that keep a slip of the finger from eating the machine's memory or the day.
inline constexpr int kMaxResolution = 8192;
inline constexpr int kMaxFrames = 100000;
inline constexpr int kMaxSegments = 2048;
inline constexpr int kMaxTextureSize = 8192;
inline constexpr int kMaxDiscs = 64;  // each way, of an object
inline constexpr int kMaxTrackValues = 256;
inline constexpr int kMaxEntries = 1024;  // objects, textures, sessions, key frames, profile points
inline constexpr std::size_t kMaxCameraRows = 20000;  // of a recording: five minutes at 60 a second
inline constexpr int kMaxUniforms = 4096;  // as many as members that a block may have
inline constexpr std::int64_t kMaxMeshQuads = 1 << 23;   // of all objects together: some 500 MB of vertices
inline constexpr std::int64_t kMaxTexels = 8192 * 8192;  // of all made-up textures together
inline constexpr int kMaxKeyParts = 64;  // of a dotted key: each is a table in the one before, and tables are left by recursion

template <typename T, std::size_t N>
const char* spellingOf(const NameWithValue<T> (&table)[N], T value) {
  for (const NameWithValue<T>& named : table) {
    if (named.value == value) return named.name;
  }
  return table[0].name;
}

}  // namespace reprise
