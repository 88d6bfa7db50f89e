// How the meshes of a scene lie in memory, as the vertex inputs of an interface read them: binding 0 is Vertex, binding 1
// DeformVertex, where the vertex shader deforms.
#pragma once

#include <vulkan/vulkan_core.h>

#include <vector>

#include "runtime/package/interface.h"

namespace reprise {

class VertexLayout {
 public:
  // The inputs must be those that checkBindings lets pass.
  explicit VertexLayout(const ShaderInterface& interface);
  // Points into this layout.
  VkPipelineVertexInputStateCreateInfo state() const;

 private:
  std::uint32_t binding_count_ = 1;
  std::vector<VkVertexInputAttributeDescription> attributes_;
};

}  // namespace reprise
