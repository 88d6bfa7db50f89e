#include "profiler/gltf/figure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "profiler/gltf/tangents.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

constexpr float kTurn = 6.2831853f;
constexpr int kRings = 6;        // of a half sphere at each end, and along the bone
constexpr int kKeys = 17;        // of the walk
constexpr float kCycle_s = 1;

// swing about x: lean + swing * sin(2 pi t / cycle + phase), bent one way only where `bends`.
struct Bone {
  const char* name;
  int parent;
  glm::vec3 head;   // in the figure's space
  glm::vec3 tail;
  float radius;
  float lean, swing, phase;
  bool bends;
};

// Angles in radians; a positive turn about x moves a hanging limb backwards.
const Bone kBones[] = {
    {"pelvis", -1, {0, 0.95f, 0}, {0, 1.05f, 0}, 0.15f, 0, 0, 0, false},
    {"spine", 0, {0, 1.05f, 0}, {0, 1.42f, 0}, 0.16f, 0.05f, 0.02f, 0, false},
    {"neck", 1, {0, 1.45f, 0}, {0, 1.55f, 0}, 0.06f, 0, 0, 0, false},
    {"head", 2, {0, 1.62f, 0}, {0, 1.70f, 0}, 0.10f, 0, 0.04f, 0, false},
    {"left_upper_arm", 1, {0.21f, 1.40f, 0}, {0.23f, 1.13f, 0}, 0.055f, 0, 0.5f, 0, false},
    {"left_forearm", 4, {0.23f, 1.11f, 0}, {0.23f, 0.82f, 0}, 0.045f, -0.35f, 0.25f, 0, true},
    {"right_upper_arm", 1, {-0.21f, 1.40f, 0}, {-0.23f, 1.13f, 0}, 0.055f, 0, 0.5f, kTurn / 2, false},
    {"right_forearm", 6, {-0.23f, 1.11f, 0}, {-0.23f, 0.82f, 0}, 0.045f, -0.35f, 0.25f, kTurn / 2, true},
    {"left_thigh", 0, {0.10f, 0.92f, 0}, {0.10f, 0.52f, 0}, 0.085f, 0, 0.55f, kTurn / 2, false},
    {"left_shin", 8, {0.10f, 0.50f, 0}, {0.10f, 0.10f, 0}, 0.06f, 0.45f, 0.45f, 0, true},
    {"right_thigh", 0, {-0.10f, 0.92f, 0}, {-0.10f, 0.52f, 0}, 0.085f, 0, 0.55f, 0, false},
    {"right_shin", 10, {-0.10f, 0.50f, 0}, {-0.10f, 0.10f, 0}, 0.06f, 0.45f, 0.45f, kTurn / 2, true},
    {"collar", 1, {-0.16f, 1.40f, 0}, {0.16f, 1.40f, 0}, 0.07f, 0, 0, 0, false},
};
constexpr std::size_t kBoneCount = std::size(kBones);

struct Ring {
  float along;   // from head to tail in metres, beyond both by the radius
  float radius;
  float normal;  // its part along the bone
};

std::vector<Ring> ringsOf(float length, float radius) {
  std::vector<Ring> rings;
  for (int i = 0; i <= kRings; ++i) {
    const float angle = kTurn / 4 * static_cast<float>(i) / kRings;
    rings.push_back({-radius * std::cos(angle), radius * std::sin(angle), -std::cos(angle)});
  }
  for (int i = 1; i < kRings; ++i) rings.push_back({length * static_cast<float>(i) / kRings, radius, 0});
  for (int i = 0; i <= kRings; ++i) {
    const float angle = kTurn / 4 * static_cast<float>(i) / kRings;
    rings.push_back({length + radius * std::sin(angle), radius * std::cos(angle), std::sin(angle)});
  }
  return rings;
}

// Half and half at the joint, all the bone's own one and a half radii further on.
DeformVertex skinned(std::size_t bone, float along) {
  DeformVertex deform{};
  const Bone& own = kBones[bone];
  const float reach = 1.5f * own.radius;
  const float share = own.parent < 0 ? 1.0f : std::clamp(0.5f + 0.5f * along / reach, 0.0f, 1.0f);
  deform.joints[0] = static_cast<float>(bone);
  deform.joints[1] = static_cast<float>(std::max(own.parent, 0));
  deform.weights[0] = share;
  deform.weights[1] = 1 - share;
  return deform;
}

void addCapsule(std::size_t bone, int segments, GltfPrimitive& primitive) {
  const Bone& from = kBones[bone];
  const glm::vec3 axis = glm::normalize(from.tail - from.head);
  const glm::vec3 aside = glm::normalize(glm::cross(axis, glm::vec3(0, 0, 1))), ahead = glm::cross(aside, axis);
  const std::vector<Ring> rings = ringsOf(glm::length(from.tail - from.head), from.radius);
  const auto first = static_cast<std::uint32_t>(primitive.vertices.size());
  const auto columns = static_cast<std::uint32_t>(segments) + 1;
  for (std::size_t row = 0; row < rings.size(); ++row)
    for (int column = 0; column <= segments; ++column) {
      const float angle = kTurn * static_cast<float>(column % segments) / static_cast<float>(segments);
      const glm::vec3 outwards = std::cos(angle) * ahead + std::sin(angle) * aside;
      const Ring& ring = rings[row];
      const glm::vec3 position = from.head + axis * ring.along + outwards * ring.radius;
      const glm::vec3 normal = outwards * std::sqrt(std::max(0.0f, 1 - ring.normal * ring.normal)) + axis * ring.normal;
      primitive.vertices.push_back({{position.x, position.y, position.z}, {normal.x, normal.y, normal.z}, {1, 0, 0, 1},
                                    {static_cast<float>(column) / static_cast<float>(segments), static_cast<float>(row) / static_cast<float>(rings.size() - 1)},
                                    {1, 1, 1, 1}});
      primitive.deform.push_back(skinned(bone, ring.along));
    }
  for (std::uint32_t row = 0; row + 1 < rings.size(); ++row)
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      const std::uint32_t a = first + row * columns + column, b = a + 1, c = a + columns, d = c + 1;
      primitive.indices.insert(primitive.indices.end(), {a, b, d, a, d, c});
    }
}

float angleOf(const Bone& bone, float part) {
  const float angle = bone.lean + bone.swing * std::sin(kTurn * part + bone.phase);
  if (!bone.bends) return angle;
  return bone.lean > 0 ? std::max(angle, 0.0f) : std::min(angle, 0.0f);
}

GltfAnimation walk() {
  GltfAnimation animation;
  animation.name = "walk";
  animation.duration_s = kCycle_s;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    GltfChannel channel;
    channel.node = static_cast<int>(bone);
    channel.target = GltfTarget::kRotation;
    channel.width = 4;
    for (int key = 0; key < kKeys; ++key) {
      const float part = static_cast<float>(key) / (kKeys - 1), half = angleOf(kBones[bone], part) / 2;
      channel.times_s.push_back(part * kCycle_s);
      channel.values.insert(channel.values.end(), {std::sin(half), 0, 0, std::cos(half)});
    }
    animation.channels.push_back(std::move(channel));
  }
  GltfChannel bob;
  bob.node = 0;
  for (int key = 0; key < kKeys; ++key) {
    const float part = static_cast<float>(key) / (kKeys - 1);
    bob.times_s.push_back(part * kCycle_s);
    bob.values.insert(bob.values.end(), {0, kBones[0].head.y + 0.02f * std::cos(2 * kTurn * part), 0});
  }
  animation.channels.push_back(std::move(bob));
  return animation;
}

}  // namespace

GltfScene makeFigure(int segments) {
  GltfScene scene;
  GltfPrimitive primitive;
  GltfSkin skin;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    const Bone& from = kBones[bone];
    GltfNode node;
    node.name = from.name;
    node.parent = from.parent;
    node.translation = from.head - (from.parent < 0 ? glm::vec3(0) : kBones[from.parent].head);
    scene.nodes.push_back(node);
    scene.order.push_back(static_cast<int>(bone));
    skin.joints.push_back(static_cast<int>(bone));
    skin.inverse_bind.push_back(glm::translate(glm::mat4(1), -from.head));
    addCapsule(bone, segments, primitive);
  }
  addTangents(primitive.vertices, primitive.deform, primitive.indices);
  GltfMaterial material;
  material.metallic = 0;
  material.roughness = 0.6f;
  scene.materials.push_back(material);
  primitive.material = 0;
  scene.meshes.push_back({{std::move(primitive)}, {}});
  scene.skins.push_back(std::move(skin));
  scene.animations.push_back(walk());
  GltfNode holder;
  holder.name = "figure";
  holder.mesh = holder.skin = 0;
  scene.nodes.push_back(holder);
  scene.order.push_back(static_cast<int>(kBoneCount));
  scene.instances.push_back({static_cast<int>(kBoneCount), 0, 0, 0, false});
  scene.hash = contentHash("figure " + std::to_string(segments));
  return scene;
}

}  // namespace reprise
