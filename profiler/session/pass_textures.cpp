#include "profiler/session/pass_textures.h"

#include "profiler/scenario/passes.h"

namespace reprise {
namespace {

Result<Handle<VkSampler>> createSampler(const DeviceView& device, VkFilter filter, bool compares) {
  VkSamplerCreateInfo create{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  create.magFilter = create.minFilter = filter;
  create.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
  create.addressModeU = create.addressModeV = create.addressModeW = compares ? VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  create.borderColor = VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE;
  create.compareEnable = compares ? VK_TRUE : VK_FALSE;
  create.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
  VkSampler sampler = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateSampler(device.device, &create, nullptr, &sampler));
  return Handle<VkSampler>(device.device, sampler, device.fn.vkDestroySampler);
}

}  // namespace

VkFormat colorFormatOf(const std::string& name) {
  if (name == "rgba16_sfloat") return VK_FORMAT_R16G16B16A16_SFLOAT;
  if (name == "rgba32_sfloat") return VK_FORMAT_R32G32B32A32_SFLOAT;
  return VK_FORMAT_R8G8B8A8_UNORM;
}

Result<PassTextures> createPassTextures(const Context& context, const Scenario& scenario) {
  const DeviceView& device = context.view();
  PassTextures textures;
  if (scenario.passes.empty()) return textures;
  for (const PassSpec& pass : scenario.passes) {
    const bool shadow = pass.kind == ScenePassKind::kShadow;
    TargetFormats formats;
    formats.extent = shadow ? VkExtent2D{pass.size, pass.size} : VkExtent2D{scenario.width, scenario.height};
    formats.sampled = true;
    for (const PassOutput& output : pass.outputs) formats.colors.push_back(colorFormatOf(output.format));
    REPRISE_ASSIGN(RenderTargets targets, createRenderTargets(device, formats));
    textures.targets.push_back(std::move(targets));
  }
  // D32_SFLOAT need not be filtered linearly: the shader's taps are what softens a shadow.
  REPRISE_ASSIGN(textures.compare, createSampler(device, VK_FILTER_NEAREST, true));
  REPRISE_ASSIGN(textures.nearest, createSampler(device, VK_FILTER_NEAREST, false));
  REPRISE_ASSIGN(textures.linear, createSampler(device, VK_FILTER_LINEAR, false));
  return textures;
}

std::optional<VkDescriptorImageInfo> passTexture(const Scenario& scenario, const PassTextures& textures, const Descriptor& descriptor) {
  const auto found = findPassTexture(scenario, descriptor.name);
  if (!found) return std::nullopt;
  const RenderTargets& targets = textures.targets[found->pass];
  const bool linear = !found->depth && scenario.passes[found->pass].outputs[found->output].linear;
  const VkSampler sampler = descriptor.compares ? textures.compare.get() : linear ? textures.linear.get() : textures.nearest.get();
  const Image& image = found->depth ? targets.depth : targets.colors[found->output];
  return VkDescriptorImageInfo{sampler, image.view.get(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
}

}  // namespace reprise
