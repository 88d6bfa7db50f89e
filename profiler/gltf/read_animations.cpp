#include <tiny_gltf.h>

#include <algorithm>

#include "profiler/gltf/gltf_parts.h"

namespace reprise {
namespace {

constexpr std::size_t kMostChannels = 1 << 16;

// The number of morph weights of a node's mesh in the file.
std::size_t weightCount(const tinygltf::Model& model, int node) {
  const int mesh = model.nodes[static_cast<std::size_t>(node)].mesh;
  if (mesh < 0 || model.meshes[static_cast<std::size_t>(mesh)].primitives.empty()) return 0;
  return model.meshes[static_cast<std::size_t>(mesh)].primitives.front().targets.size();
}

Result<GltfInterpolation> interpolationOf(const std::string& name, const std::string& where) {
  if (name == "STEP") return GltfInterpolation::kStep;
  if (name == "LINEAR") return GltfInterpolation::kLinear;
  if (name == "CUBICSPLINE") return GltfInterpolation::kCubicSpline;
  return gltfError("value", where + ".interpolation", "it is '" + name + "', expected STEP, LINEAR or CUBICSPLINE");
}

Result<void> readKeys(const tinygltf::Model& model, const tinygltf::AnimationSampler& from, const std::string& where, GltfChannel& channel) {
  REPRISE_ASSIGN(channel.interpolation, interpolationOf(from.interpolation, where));
  REPRISE_ASSIGN(AccessorFloats times, readAccessor(model, from.input, 1, where + ".input"));
  REPRISE_ASSIGN(AccessorFloats values, readAccessor(model, from.output, 0, where + ".output"));
  channel.times_s = std::move(times.values);
  channel.values = std::move(values.values);
  for (std::size_t i = 0; i < channel.times_s.size(); ++i)
    if (channel.times_s[i] < 0 || (i > 0 && channel.times_s[i] <= channel.times_s[i - 1]))
      return gltfError("value", where + ".input", "time " + std::to_string(i) + " does not lie after the one before it");
  const std::size_t wanted = channel.times_s.size() * channel.width * (channel.interpolation == GltfInterpolation::kCubicSpline ? 3 : 1);
  if (channel.values.size() != wanted)
    return gltfError("accessor", where + ".output", "it has " + std::to_string(channel.values.size()) + " numbers, expected " + std::to_string(wanted));
  return {};
}

}  // namespace

Result<void> readAnimations(const tinygltf::Model& model, GltfScene& scene) {
  for (std::size_t a = 0; a < model.animations.size(); ++a) {
    const tinygltf::Animation& from = model.animations[a];
    GltfAnimation animation;
    animation.name = from.name;
    if (from.channels.size() > kMostChannels) return gltfError("limit", elementPath("animations", a) + ".channels", "there are " + std::to_string(from.channels.size()));
    for (std::size_t c = 0; c < from.channels.size(); ++c) {
      const std::string where = elementPath(elementPath("animations", a) + ".channels", c);
      const tinygltf::AnimationChannel& source = from.channels[c];
      if (source.target_node < 0) continue;
      REPRISE_TRY(expectIndex(source.target_node, scene.nodes.size(), where + ".target.node"));
      REPRISE_TRY(expectIndex(source.sampler, from.samplers.size(), where + ".sampler"));
      GltfChannel channel;
      channel.node = source.target_node;
      if (source.target_path == "translation" || source.target_path == "scale") {
        channel.target = source.target_path == "scale" ? GltfTarget::kScale : GltfTarget::kTranslation;
      } else if (source.target_path == "rotation") {
        channel.target = GltfTarget::kRotation;
        channel.width = 4;
      } else if (source.target_path == "weights" && weightCount(model, channel.node) > 0) {
        channel.target = GltfTarget::kWeights;
        channel.width = weightCount(model, channel.node);
      } else {
        scene.warnings.push_back(where + ": '" + source.target_path + "' is not animated");
        continue;
      }
      REPRISE_TRY(readKeys(model, from.samplers[static_cast<std::size_t>(source.sampler)], elementPath(elementPath("animations", a) + ".samplers", static_cast<std::size_t>(source.sampler)), channel));
      animation.duration_s = std::max(animation.duration_s, channel.times_s.back());
      animation.channels.push_back(std::move(channel));
    }
    scene.animations.push_back(std::move(animation));
  }
  return {};
}

}  // namespace reprise
