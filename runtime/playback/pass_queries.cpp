#include "runtime/playback/pass_queries.h"

namespace reprise {

PassQueries::PassQueries(const DeviceView& device, VkCommandBuffer commands, const FrameInputs& inputs, std::uint32_t passes)
    : device_(device), commands_(commands), inputs_(inputs) {
  if (inputs.timestamps != VK_NULL_HANDLE) {
    device.fn.vkCmdResetQueryPool(commands, inputs.timestamps, inputs.first_query, passes + 1);
    device.fn.vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, inputs.timestamps, inputs.first_query);
  }
  if (inputs.occlusion != VK_NULL_HANDLE) device.fn.vkCmdResetQueryPool(commands, inputs.occlusion, inputs.first_occlusion, passes);
}

void PassQueries::beginCounting(std::uint32_t pass) const {
  if (inputs_.occlusion != VK_NULL_HANDLE)
    device_.fn.vkCmdBeginQuery(commands_, inputs_.occlusion, inputs_.first_occlusion + pass, VK_QUERY_CONTROL_PRECISE_BIT);
}

void PassQueries::endCounting(std::uint32_t pass) const {
  if (inputs_.occlusion != VK_NULL_HANDLE) device_.fn.vkCmdEndQuery(commands_, inputs_.occlusion, inputs_.first_occlusion + pass);
}

void PassQueries::stampEnd(std::uint32_t pass) const {
  if (inputs_.timestamps != VK_NULL_HANDLE)
    device_.fn.vkCmdWriteTimestamp(commands_, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, inputs_.timestamps, inputs_.first_query + pass + 1);
}

}  // namespace reprise
