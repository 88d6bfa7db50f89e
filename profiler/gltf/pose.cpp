#include "profiler/gltf/pose.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace reprise {
namespace {

constexpr int kBoundsSamples = 8;

// The values of a key: its middle third with cubic splines.
const float* keyValues(const GltfChannel& channel, std::size_t key, std::size_t part) {
  const std::size_t parts = channel.interpolation == GltfInterpolation::kCubicSpline ? 3 : 1;
  return &channel.values[(key * parts + (parts == 3 ? part : 0)) * channel.width];
}

glm::quat quatFrom(const float* v) { return {v[3], v[0], v[1], v[2]}; }

std::vector<float> sample(const GltfChannel& channel, float time_s) {
  const auto after = std::upper_bound(channel.times_s.begin(), channel.times_s.end(), time_s);
  const auto next = static_cast<std::size_t>(after - channel.times_s.begin());
  const std::size_t key = next == 0 ? 0 : next - 1;
  const float* here = keyValues(channel, key, 1);
  std::vector<float> values(here, here + channel.width);
  if (next == 0 || next == channel.times_s.size() || channel.interpolation == GltfInterpolation::kStep) return values;
  const float span = channel.times_s[next] - channel.times_s[key], t = (time_s - channel.times_s[key]) / span;
  const float* there = keyValues(channel, next, 1);
  if (channel.interpolation == GltfInterpolation::kLinear && channel.target == GltfTarget::kRotation) {
    const glm::quat turn = glm::slerp(glm::normalize(quatFrom(here)), glm::normalize(quatFrom(there)), t);
    return {turn.x, turn.y, turn.z, turn.w};
  }
  const float *leaving = keyValues(channel, key, 2), *arriving = keyValues(channel, next, 0);
  const float t2 = t * t, t3 = t2 * t;
  for (std::size_t i = 0; i < channel.width; ++i)
    values[i] = channel.interpolation == GltfInterpolation::kLinear
                    ? here[i] + t * (there[i] - here[i])
                    : (2 * t3 - 3 * t2 + 1) * here[i] + span * (t3 - 2 * t2 + t) * leaving[i] + (3 * t2 - 2 * t3) * there[i] + span * (t3 - t2) * arriving[i];
  return values;
}

void apply(const GltfChannel& channel, float time_s, GltfNode& node) {
  const std::vector<float> values = sample(channel, time_s);
  switch (channel.target) {
    case GltfTarget::kTranslation: node.translation = {values[0], values[1], values[2]}; break;
    case GltfTarget::kScale: node.scale = {values[0], values[1], values[2]}; break;
    case GltfTarget::kRotation: {
      const glm::quat turn = quatFrom(values.data());
      if (glm::length(turn) > 1e-6f) node.rotation = glm::normalize(turn);
      break;
    }
    case GltfTarget::kWeights: node.weights = values; break;
  }
}

glm::mat4 localMatrix(const GltfNode& node) {
  if (node.has_matrix) return node.matrix;
  return glm::scale(glm::translate(glm::mat4(1), node.translation) * glm::mat4_cast(node.rotation), node.scale);
}

}  // namespace

GltfPose poseAt(const GltfScene& scene, const GltfAnimation* animation, double time_s) {
  std::vector<GltfNode> nodes = scene.nodes;
  if (animation != nullptr) {
    double within = animation->duration_s > 0 ? std::fmod(time_s, static_cast<double>(animation->duration_s)) : 0;
    if (within < 0) within += animation->duration_s;
    for (const GltfChannel& channel : animation->channels) apply(channel, static_cast<float>(within), nodes[static_cast<std::size_t>(channel.node)]);
  }
  GltfPose pose;
  pose.nodes.assign(nodes.size(), glm::mat4(1));
  for (const int index : scene.order) {
    const GltfNode& node = nodes[static_cast<std::size_t>(index)];
    const glm::mat4 above = node.parent >= 0 ? pose.nodes[static_cast<std::size_t>(node.parent)] : glm::mat4(1);
    pose.nodes[static_cast<std::size_t>(index)] = above * localMatrix(node);
  }
  for (const GltfSkin& skin : scene.skins) {
    std::vector<glm::mat4> joints;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) joints.push_back(pose.nodes[static_cast<std::size_t>(skin.joints[j])] * skin.inverse_bind[j]);
    pose.joints.push_back(std::move(joints));
  }
  for (const GltfNode& node : nodes)
    pose.weights.push_back(!node.weights.empty() || node.mesh < 0 ? node.weights : scene.meshes[static_cast<std::size_t>(node.mesh)].weights);
  return pose;
}

std::array<float, kMorphTargets> keptWeights(const GltfScene& scene, const GltfPose& pose, const GltfInstance& instance) {
  std::array<float, kMorphTargets> kept = {};
  const std::vector<float>& weights = pose.weights[static_cast<std::size_t>(instance.node)];
  const std::vector<std::size_t>& targets = primitiveOf(scene, instance).targets;
  for (std::size_t slot = 0; slot < targets.size(); ++slot)
    if (targets[slot] < weights.size()) kept[slot] = weights[targets[slot]];
  return kept;
}

glm::vec3 positionAt(const GltfScene& scene, const GltfPose& pose, const GltfInstance& instance, std::size_t vertex) {
  const GltfPrimitive& primitive = primitiveOf(scene, instance);
  const float* p = primitive.vertices[vertex].position;
  glm::vec3 position(p[0], p[1], p[2]);
  if (primitive.deform.empty()) return glm::vec3(pose.nodes[static_cast<std::size_t>(instance.node)] * glm::vec4(position, 1));
  const DeformVertex& deform = primitive.deform[vertex];
  const std::array<float, kMorphTargets> weights = keptWeights(scene, pose, instance);
  for (std::size_t t = 0; t < kMorphTargets; ++t)
    for (int i = 0; i < 3; ++i) position[i] += weights[t] * deform.morph_position[t][i];
  if (instance.skin < 0) return glm::vec3(pose.nodes[static_cast<std::size_t>(instance.node)] * glm::vec4(position, 1));
  glm::mat4 blended(0);
  for (int j = 0; j < 4; ++j)
    blended += deform.weights[j] * pose.joints[static_cast<std::size_t>(instance.skin)][static_cast<std::size_t>(deform.joints[j])];
  return glm::vec3(blended * glm::vec4(position, 1));
}

GltfBounds boundsOf(const GltfScene& scene, const GltfAnimation* animation) {
  GltfBounds bounds;
  bool first = true;
  const int samples = animation != nullptr ? kBoundsSamples : 1;
  for (int s = 0; s < samples; ++s) {
    const GltfPose pose = poseAt(scene, animation, animation != nullptr ? static_cast<double>(animation->duration_s) * s / samples : 0);
    for (const GltfInstance& instance : scene.instances)
      for (std::size_t v = 0; v < primitiveOf(scene, instance).vertices.size(); ++v) {
        const glm::vec3 position = positionAt(scene, pose, instance, v);
        bounds.low = first ? position : glm::min(bounds.low, position);
        bounds.high = first ? position : glm::max(bounds.high, position);
        first = false;
      }
  }
  return bounds;
}

}  // namespace reprise
