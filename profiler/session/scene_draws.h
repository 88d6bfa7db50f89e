// What is the same for every rendering of a scene's objects: filling their uniforms, binding them.
#pragma once

#include "profiler/session/scene_objects.h"

namespace reprise {

struct SceneMoment {
  const Scenario* scenario = nullptr;
  const SessionSpec* session = nullptr;
  const FrameState* frame = nullptr;
};

// Uniform blocks and push constants of all objects; interface: that of the scene.
void fillScene(const SceneMoment& moment, const ShaderInterface& interface, SceneObjects& scene);

struct DrawTarget {
  const DeviceView* device = nullptr;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  VkPipelineLayout layout = VK_NULL_HANDLE;
};

// Descriptor sets, push constants, vertices and indices.
void bindObject(const DrawTarget& target, const SceneObjects& scene, std::size_t object);

}  // namespace reprise
