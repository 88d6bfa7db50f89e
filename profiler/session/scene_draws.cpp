#include "profiler/session/scene_draws.h"

#include <cstring>

namespace reprise {

void fillScene(const SceneMoment& moment, const ShaderInterface& interface, SceneObjects& scene) {
  const std::size_t count = scene.objects.size();
  for (BlockSlots& block : scene.blocks)
    for (std::size_t object = 0; object < count; ++object) {
      const Descriptor& descriptor = *block.descriptor;
      const auto bytes = fillBlock(*moment.scenario, *moment.session, *moment.frame, object, descriptor.name, descriptor.members, descriptor.size_bytes);
      std::memcpy(&block.buffer.mapped[block.stride * object], bytes.data(), bytes.size());
    }
  scene.push_constants.resize(count);
  if (scene.push_bytes == 0) return;
  for (std::size_t object = 0; object < count; ++object)
    scene.push_constants[object] = fillBlock(*moment.scenario, *moment.session, *moment.frame, object, interface.push_constant_name,
                                             interface.push_constant_members, scene.push_bytes);
}

void bindObject(const DrawTarget& target, const SceneObjects& scene, std::size_t object) {
  const VulkanFunctions& fn = target.device->fn;
  const std::vector<VkDescriptorSet>& sets = scene.sets[object];
  if (!sets.empty())
    fn.vkCmdBindDescriptorSets(target.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, target.layout, 0, static_cast<std::uint32_t>(sets.size()), sets.data(), 0, nullptr);
  for (const VkPushConstantRange& range : scene.push_ranges)
    fn.vkCmdPushConstants(target.commands, target.layout, range.stageFlags, range.offset, range.size, scene.push_constants[object].data() + range.offset);
  const ObjectBuffers& buffers = scene.objects[object];
  const VkBuffer vertices = buffers.vertices.buffer.get();
  const VkDeviceSize offset = 0;
  fn.vkCmdBindVertexBuffers(target.commands, 0, 1, &vertices, &offset);
  if (const VkBuffer deform = buffers.deform.buffer.get(); deform != VK_NULL_HANDLE) fn.vkCmdBindVertexBuffers(target.commands, 1, 1, &deform, &offset);
  fn.vkCmdBindIndexBuffer(target.commands, buffers.indices.buffer.get(), 0, VK_INDEX_TYPE_UINT32);
}

}  // namespace reprise
