// A scene at one time: where its nodes are, and how its skins and morph targets stand (glTF 2.0, sections 3.7.3 and 3.11).
#pragma once

#include <array>
#include <vector>

#include "profiler/gltf/gltf_scene.h"

namespace reprise {

struct GltfPose {
  std::vector<glm::mat4> nodes;                // to the scene's space, by node; those that the scene does not reach: unit
  std::vector<std::vector<glm::mat4>> joints;  // by skin: from the bind pose to the scene's space
  std::vector<std::vector<float>> weights;     // of all morph targets of the file, by node
};

// animation: null for the pose at rest. Times run in a circle of the animation's duration; negative ones count from its end.
GltfPose poseAt(const GltfScene& scene, const GltfAnimation* animation, double time_s);

// The weights of the targets that an instance's primitive keeps, in their order; the rest 0.
std::array<float, kMorphTargets> keptWeights(const GltfScene& scene, const GltfPose& pose, const GltfInstance& instance);

// A vertex's position in the scene's space: morphed, then skinned or moved by its node. The reference of what shaders do.
glm::vec3 positionAt(const GltfScene& scene, const GltfPose& pose, const GltfInstance& instance, std::size_t vertex);

// The box around all instances over an animation, sampled at 8 times.
struct GltfBounds {
  glm::vec3 low{0}, high{0};
};
GltfBounds boundsOf(const GltfScene& scene, const GltfAnimation* animation);

}  // namespace reprise
