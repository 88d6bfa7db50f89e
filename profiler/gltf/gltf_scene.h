// A glTF 2.0 scene as plain values: what is drawn, how it is lit, how it moves. Units are glTF's: metres, radians, seconds;
// right-handed, y up; candela and lux as they stand in the file.
#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "profiler/gltf/vertex.h"

namespace reprise {

// An encoded image as it lay in the file: PNG or JPEG.
struct GltfImage {
  std::string name;  // its JSON path and its file, for messages
  std::string bytes;
};

// Index into images, or -1: none.
struct GltfTexture {
  int image = -1;
  bool linear = true;
  bool repeat = true;
};

struct GltfMaterial {
  std::array<float, 4> base_color = {1, 1, 1, 1};
  float metallic = 1, roughness = 1, normal_scale = 1, occlusion_strength = 1;
  std::array<float, 3> emissive = {0, 0, 0};
  float alpha_cutoff = 0;  // 0: opaque. Blended materials are drawn opaque
  bool double_sided = false;
  GltfTexture base_color_map, metallic_roughness_map, normal_map, occlusion_map, emissive_map;
};

// Indexed triangles. `deform` is as long as `vertices`, or empty where nothing is skinned or morphed.
struct GltfPrimitive {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<DeformVertex> deform;
  std::vector<std::size_t> targets;  // those that are kept, by their index in the file; at most kMorphTargets
  int material = -1;                 // -1: glTF's default material
};

struct GltfMesh {
  std::vector<GltfPrimitive> primitives;
  std::vector<float> weights;  // of all morph targets of the file
};

struct GltfNode {
  std::string name;
  int parent = -1;
  glm::vec3 translation{0};
  glm::quat rotation{1, 0, 0, 0};
  glm::vec3 scale{1};
  bool has_matrix = false;  // instead of the three, which are then not animated
  glm::mat4 matrix{1};
  int mesh = -1, skin = -1, camera = -1, light = -1;
  std::vector<float> weights;  // empty: the mesh's
};

struct GltfSkin {
  std::vector<int> joints;  // nodes
  std::vector<glm::mat4> inverse_bind;
};

enum class GltfTarget { kTranslation, kRotation, kScale, kWeights };
enum class GltfInterpolation { kStep, kLinear, kCubicSpline };

// values: `width` floats a key; with cubic splines in-tangent, value and out-tangent, so three times as many.
struct GltfChannel {
  int node = 0;
  GltfTarget target = GltfTarget::kTranslation;
  GltfInterpolation interpolation = GltfInterpolation::kLinear;
  std::vector<float> times_s;
  std::vector<float> values;
  std::size_t width = 3;
};

struct GltfAnimation {
  std::string name;
  float duration_s = 0;
  std::vector<GltfChannel> channels;
};

struct GltfCamera {
  std::string name;
  bool orthographic = false;
  float fov_y_rad = 0.8f;      // perspective
  float height = 2;            // orthographic: of the view volume
  float near_plane = 0.1f, far_plane = 100;  // far: infinity where the file has none (perspective)
};

enum class GltfLightKind { kDirectional, kPoint, kSpot };

struct GltfLight {
  GltfLightKind kind = GltfLightKind::kPoint;
  std::array<float, 3> color = {1, 1, 1};  // times intensity
  float range = 0;                         // 0: without end
  float inner_cone_rad = 0, outer_cone_rad = 0.7853982f;
};

// One primitive where it is drawn. mirrored: its node turns the winding around.
struct GltfInstance {
  int node = 0, mesh = 0, primitive = 0, skin = -1;
  bool mirrored = false;
};

struct GltfScene {
  std::vector<GltfNode> nodes;
  std::vector<int> order;  // the nodes of the scene, parents first
  std::vector<GltfMesh> meshes;
  std::vector<GltfMaterial> materials;
  std::vector<GltfImage> images;
  std::vector<GltfSkin> skins;
  std::vector<GltfAnimation> animations;
  std::vector<GltfCamera> cameras;
  std::vector<GltfLight> lights;
  std::vector<GltfInstance> instances;  // by node in order, then primitive
  std::vector<std::string> files;       // read besides the file itself, relative to its folder
  std::vector<std::string> warnings;    // what was left out
  std::string hash;                     // of the bytes of all files
};

inline const GltfPrimitive& primitiveOf(const GltfScene& scene, const GltfInstance& instance) {
  return scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives[static_cast<std::size_t>(instance.primitive)];
}

}  // namespace reprise
