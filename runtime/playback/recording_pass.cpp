#include "runtime/playback/recording_pass.h"

namespace reprise {

void RecordingPass::bindDraw(std::uint64_t id) {
  if (!parts_.binds) return;
  const auto found = parts_.places->find(id);
  REPRISE_CHECK(found != parts_.places->end(), id);
  const auto& [index, offsets] = found->second;
  *parts_.drawn = true;
  endObject();
  if (parts_.conditions != VK_NULL_HANDLE) {
    VkConditionalRenderingBeginInfoEXT condition{VK_STRUCTURE_TYPE_CONDITIONAL_RENDERING_BEGIN_INFO_EXT};
    condition.buffer = parts_.conditions;
    condition.offset = index * sizeof(std::uint32_t);
    parts_.device->fn.vkCmdBeginConditionalRenderingEXT(parts_.commands, &condition);
    conditional_ = true;
  }
  parts_.device->fn.vkCmdBindDescriptorSets(parts_.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, parts_.layout, parts_.set_index, 1, &parts_.set,
                                            static_cast<std::uint32_t>(offsets.size()), offsets.data());
}

void RecordingPass::endObject() {
  if (conditional_) parts_.device->fn.vkCmdEndConditionalRenderingEXT(parts_.commands);
  conditional_ = false;
}

}  // namespace reprise
