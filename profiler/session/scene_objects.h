// A scenario's geometry, textures and shader inputs on a device: what an application would own.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "profiler/scenario/scenario.h"
#include "profiler/scene/frame_state.h"
#include "profiler/session/pass_textures.h"
#include "runtime/package/interface.h"
#include "runtime/vulkan/buffer.h"
#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/image.h"

namespace reprise {

struct ObjectBuffers {
  Buffer vertices, indices;
  Buffer deform;  // DeformVertex by vertex; none where the vertex shader does not read them
  std::uint32_t index_count = 0;
};

// One uniform block of the interface, with a slot for each object (all alike where the block is per frame).
struct BlockSlots {
  const Descriptor* descriptor = nullptr;
  Buffer buffer;
  VkDeviceSize stride = 0;
};

struct SceneObjects {
  std::vector<ObjectBuffers> objects;
  std::deque<Image> textures;
  std::vector<Handle<VkSampler>> samplers;
  std::vector<Handle<VkDescriptorSetLayout>> set_layouts;  // sets 0.. of the interface; empty ones fill gaps
  Handle<VkDescriptorPool> pool;
  std::vector<std::vector<VkDescriptorSet>> sets;          // by object, then set
  std::vector<BlockSlots> blocks;
  std::vector<VkPushConstantRange> push_ranges;
  std::uint32_t push_bytes = 0;
  std::vector<std::vector<std::byte>> push_constants;      // by object
};

// What a scene on a device is made from; all of it must outlive the scene.
struct SceneSource {
  const Scenario* scenario = nullptr;
  const ShaderInterface* interface = nullptr;
  std::shared_ptr<const PassTextures> textures;  // of the scenario's passes
};

// Whether the vertex shader reads joints, weights or morph targets: then DeformVertex is its second vertex binding.
bool readsDeformation(const ShaderInterface& interface);

// Errors: texture.* (kInput), scenario.unsupported (kInput; a descriptor that the profiler cannot fill), device.*.
Result<SceneObjects> createSceneObjects(const Context& context, Commands& commands, const SceneSource& source);

}  // namespace reprise
