#include "profiler/session/vertex_layout.h"

#include <algorithm>
#include <cstddef>
#include <map>

#include "profiler/gltf/vertex.h"
#include "profiler/session/scene_objects.h"

namespace reprise {
namespace {

VkFormat attributeFormat(int components) {
  constexpr VkFormat kFormats[] = {VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT, VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT};
  return kFormats[std::min(std::max(components, 1), 4) - 1];
}

// Where a vertex input lies: of which binding, how far in, and how many floats it has.
struct Attribute {
  std::uint32_t binding = 0;
  std::size_t offset = 0;
  int components = 4;
};

Attribute attributeOf(const std::string& name) {
  std::map<std::string, Attribute> attributes = {{"position", {0, offsetof(Vertex, position), 3}}, {"normal", {0, offsetof(Vertex, normal), 3}},
                                                 {"tangent", {0, offsetof(Vertex, tangent), 4}},   {"uv", {0, offsetof(Vertex, uv), 2}},
                                                 {"color", {0, offsetof(Vertex, color), 4}},       {"joints", {1, offsetof(DeformVertex, joints), 4}},
                                                 {"weights", {1, offsetof(DeformVertex, weights), 4}}};
  for (std::size_t target = 0; target < kMorphTargets; ++target) {
    const std::size_t offset = target * 3 * sizeof(float);
    attributes["morph_position_" + std::to_string(target)] = {1, offsetof(DeformVertex, morph_position) + offset, 3};
    attributes["morph_normal_" + std::to_string(target)] = {1, offsetof(DeformVertex, morph_normal) + offset, 3};
  }
  const auto found = attributes.find(name);
  REPRISE_CHECK(found != attributes.end(), name);
  return found->second;
}

}  // namespace

VertexLayout::VertexLayout(const ShaderInterface& interface) : binding_count_(readsDeformation(interface) ? 2 : 1) {
  for (const VertexInput& input : interface.vertex_inputs) {
    const Attribute attribute = attributeOf(input.name);
    attributes_.push_back({input.location, attribute.binding, attributeFormat(std::min(input.components, attribute.components)),
                           static_cast<std::uint32_t>(attribute.offset)});
  }
}

VkPipelineVertexInputStateCreateInfo VertexLayout::state() const {
  static constexpr VkVertexInputBindingDescription kBindings[] = {{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX},
                                                                  {1, sizeof(DeformVertex), VK_VERTEX_INPUT_RATE_VERTEX}};
  VkPipelineVertexInputStateCreateInfo state{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  state.vertexBindingDescriptionCount = binding_count_;
  state.pVertexBindingDescriptions = kBindings;
  state.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes_.size());
  state.pVertexAttributeDescriptions = attributes_.data();
  return state;
}

}  // namespace reprise
