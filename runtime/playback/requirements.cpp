#include "runtime/playback/requirements.h"

#include <algorithm>

#include "runtime/playback/formats.h"

namespace reprise {
namespace {

Error badPipeline(const std::string& what) {
  return {ErrorKind::kInput, "player.pipeline", "the application's pipeline " + what, {}};
}

bool blends(const VkPipelineColorBlendStateCreateInfo* state) {
  if (state == nullptr) return false;
  return std::any_of(state->pAttachments, state->pAttachments + state->attachmentCount,
                     [](const VkPipelineColorBlendAttachmentState& one) { return one.blendEnable == VK_TRUE; });
}

std::string missingState(const Recipe& recipe, const ApplicationPipeline& application) {
  const VkGraphicsPipelineCreateInfo& state = *application.create_info;
  const VkPipelineDepthStencilStateCreateInfo* depth = state.pDepthStencilState;
  if (application.depth_format == VK_FORMAT_UNDEFINED || depth == nullptr || depth->depthTestEnable == VK_FALSE ||
      depth->depthWriteEnable == VK_FALSE)
    return "the pipeline does not test and write depth";
  if (state.pMultisampleState->rasterizationSamples > VK_SAMPLE_COUNT_1_BIT) return "the pipeline is multisampled";
  if (state.pMultisampleState->alphaToCoverageEnable == VK_TRUE) return "the pipeline turns alpha to coverage";
  if (blends(state.pColorBlendState)) return "the pipeline blends";
  const bool strict = depth->depthCompareOp == VK_COMPARE_OP_LESS || depth->depthCompareOp == VK_COMPARE_OP_GREATER;
  if (recipe.requirements.depth_less_or_greater && !strict) return "the strategy needs a LESS or GREATER depth test";
  if (recipe.requirements.stencil && !hasStencil(application.depth_format)) return "the strategy needs a depth target with stencil";
  if (recipe.requirements.stencil && depth->stencilTestEnable == VK_TRUE) return "the application uses the stencil itself";
  if (application.set_layouts.size() > recipe.reprise_set)
    return "descriptor set " + std::to_string(recipe.reprise_set) + " is taken by the application";
  if (recipe.requirements.shared_inputs && !application.draws_share_inputs)
    return "the strategy needs all draws of a frame to share what the fragment shader reads, which the application does not say (ApplicationPipeline::draws_share_inputs)";
  if (recipe.requirements.rejected_lanes_load && !application.rejected_lanes_load)
    return "the shader takes derivatives of what it reads from storage buffers, and the application does not say that lanes which early tests reject read them on this device (ApplicationPipeline::rejected_lanes_load)";
  if (recipe.requirements.conditional_rendering && !application.conditional_rendering)
    return "the strategy needs VK_EXT_conditional_rendering, which the device lacks or the application does not enable (ApplicationPipeline::conditional_rendering)";
  return "";
}

std::string missingLimit(const DeviceView& device, const Recipe& recipe) {
  VkPhysicalDeviceProperties properties;
  device.fn.vkGetPhysicalDeviceProperties(device.physical_device, &properties);
  const VkPhysicalDeviceLimits& limits = properties.limits;
  if (static_cast<std::int64_t>(recipe.requirements.color_attachments) > limits.maxColorAttachments)
    return "the device has only " + std::to_string(limits.maxColorAttachments) + " colour attachments";
  if (recipe.reprise_set >= limits.maxBoundDescriptorSets) return "the device has no free descriptor set";
  const auto dynamic = 1 + std::count_if(recipe.previous_inputs.begin(), recipe.previous_inputs.end(), [](const PreviousInput& input) {
                         return input.source == PreviousSource::kUniformBlock;
                       });
  if (static_cast<std::uint64_t>(dynamic) > limits.maxDescriptorSetUniformBuffersDynamic)
    return "the device has too few dynamic uniform buffers";
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  device.fn.vkGetPhysicalDeviceFeatures2(device.physical_device, &features);
  if (recipe.requirements.independent_blend && features.features.independentBlend == VK_FALSE)
    return "the device cannot blend each target by itself";
  if (recipe.requirements.fragment_stores && features.features.fragmentStoresAndAtomics == VK_FALSE)
    return "the device has no stores in fragment shaders";
  if (recipe.requirements.conditional_rendering && device.fn.vkCmdBeginConditionalRenderingEXT == nullptr)
    return "the device was made without VK_EXT_conditional_rendering";
  return "";
}

std::string missingFormat(const DeviceView& device, const Recipe& recipe) {
  for (const Resource& resource : recipe.resources) {
    VkFormatProperties format;
    device.fn.vkGetPhysicalDeviceFormatProperties(device.physical_device, vulkanFormat(resource.format), &format);
    VkFormatFeatureFlags wanted = VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
    const bool may_be_filtered = resource.lifetime == Lifetime::kHistory && !isUint(resource.format);
    if (recipe.requirements.linear_filter && may_be_filtered)
      wanted |= VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
    if ((format.optimalTilingFeatures & wanted) != wanted) return std::string("the device cannot render to and filter ") + nameOf(resource.format);
  }
  return "";
}

}  // namespace

std::string missingRequirement(const DeviceView& device, const Recipe& recipe, const ApplicationPipeline& application) {
  if (!recipe.uses_reprise_set) return "";
  std::string missing = missingState(recipe, application);
  if (missing.empty()) missing = missingLimit(device, recipe);
  return missing.empty() ? missingFormat(device, recipe) : missing;
}

Result<void> checkApplication(const Package& package, const ApplicationPipeline& application) {
  const VkGraphicsPipelineCreateInfo* state = application.create_info;
  if (state == nullptr) return badPipeline("was not given (create_info is null)");
  if (state->pVertexInputState == nullptr || state->pInputAssemblyState == nullptr || state->pRasterizationState == nullptr ||
      state->pMultisampleState == nullptr)
    return badPipeline("lacks its vertex input, input assembly, rasterization or multisample state");
  if (application.color_formats.size() < package.interface.outputs.size())
    return badPipeline("has " + std::to_string(application.color_formats.size()) + " colour formats, but the shader writes " +
                       std::to_string(package.interface.outputs.size()) + " outputs");
  return {};
}

Result<void> checkFrame(const ApplicationPipeline& application, const FrameInputs& frame) {
  if (frame.extent.width == 0 || frame.extent.height == 0)
    return Error{ErrorKind::kInput, "player.extent",
                 "the frame is " + std::to_string(frame.extent.width) + " by " + std::to_string(frame.extent.height) +
                     " pixels; skip frames without pixels", {}};
  if (frame.colors.size() < application.color_formats.size())
    return Error{ErrorKind::kInput, "player.target_missing",
                 "the frame has " + std::to_string(frame.colors.size()) + " colour targets, the pipeline " +
                     std::to_string(application.color_formats.size()), {}};
  if (application.depth_format != VK_FORMAT_UNDEFINED && frame.depth.view == VK_NULL_HANDLE)
    return Error{ErrorKind::kInput, "player.target_missing", "the frame has no depth target, but the pipeline has", {}};
  return {};
}

}  // namespace reprise
