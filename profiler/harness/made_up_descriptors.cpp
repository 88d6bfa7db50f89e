#include "profiler/harness/made_up_descriptors.h"

#include <algorithm>
#include <cstring>

#include "runtime/package/interface_queries.h"
#include "runtime/playback/formats.h"

namespace reprise {
namespace {

constexpr VkShaderStageFlags kBothStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
constexpr std::size_t kUnsizedArrayBytes = 4096;  // room for arrays without a size at the end of storage blocks
constexpr std::uint32_t kMostDescriptors = 4096;  // of one array

class DescriptorMaker {
 public:
  DescriptorMaker(const Context& context, Commands& commands, const ShaderInterface& interface, const Descriptor* own, const IntegerAssignment& given,
                  MadeUpValues& values)
      : context_(context), device_(context.view()), commands_(commands), interface_(interface), own_(own), given_(given), values_(values) {}

  Result<MadeUpDescriptors> make() {
    for (const Descriptor& descriptor : interface_.descriptors)
      if (descriptor.count > kMostDescriptors)
        return Error{ErrorKind::kInput, "harness.unsupported", "'" + descriptor.name + "' is an array of too many descriptors", {}};
    REPRISE_TRY(createLayouts());
    REPRISE_TRY(allocateSets());
    for (const Descriptor& descriptor : interface_.descriptors)
      if (&descriptor != own_) REPRISE_TRY(write(descriptor));
    return std::move(made_);
  }

 private:
  VkDescriptorType typeFor(const Descriptor& descriptor) const {
    return &descriptor == own_ ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC : descriptorType(descriptor.kind);
  }

  Result<void> createLayouts() {
    std::uint32_t sets = 0;
    for (const Descriptor& descriptor : interface_.descriptors) sets = std::max(sets, descriptor.set + 1);
    for (std::uint32_t set = 0; set < sets; ++set) {
      std::vector<VkDescriptorSetLayoutBinding> bindings;
      for (const Descriptor& descriptor : interface_.descriptors)
        if (descriptor.set == set) bindings.push_back({descriptor.binding, typeFor(descriptor), descriptor.count, kBothStages, nullptr});
      VkDescriptorSetLayoutCreateInfo create{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
      create.bindingCount = static_cast<std::uint32_t>(bindings.size());
      create.pBindings = bindings.data();
      VkDescriptorSetLayout layout = VK_NULL_HANDLE;
      REPRISE_VK(device_.fn.vkCreateDescriptorSetLayout(device_.device, &create, nullptr, &layout));
      made_.layouts.emplace_back(device_.device, layout, device_.fn.vkDestroyDescriptorSetLayout);
    }
    return {};
  }

  Result<void> allocateSets() {
    if (made_.layouts.empty()) return {};
    std::vector<VkDescriptorPoolSize> sizes;
    for (const Descriptor& descriptor : interface_.descriptors) sizes.push_back({typeFor(descriptor), descriptor.count});
    VkDescriptorPoolCreateInfo create{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    create.maxSets = static_cast<std::uint32_t>(made_.layouts.size());
    create.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    create.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    REPRISE_VK(device_.fn.vkCreateDescriptorPool(device_.device, &create, nullptr, &pool));
    made_.pool = {device_.device, pool, device_.fn.vkDestroyDescriptorPool};
    std::vector<VkDescriptorSetLayout> layouts;
    for (const auto& layout : made_.layouts) layouts.push_back(layout.get());
    made_.sets.resize(layouts.size());
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = static_cast<std::uint32_t>(layouts.size());
    allocate.pSetLayouts = layouts.data();
    REPRISE_VK(device_.fn.vkAllocateDescriptorSets(device_.device, &allocate, made_.sets.data()));
    return {};
  }

  // An array's elements share their content.
  Result<void> write(const Descriptor& descriptor) {
    VkDescriptorBufferInfo buffer{VK_NULL_HANDLE, 0, VK_WHOLE_SIZE};
    VkDescriptorImageInfo image{};
    VkBufferView view = VK_NULL_HANDLE;
    switch (descriptor.kind) {
      case DescriptorKind::kUniformBlock:
      case DescriptorKind::kStorageBlock: {
        REPRISE_ASSIGN(buffer.buffer, block(descriptor));
        break;
      }
      case DescriptorKind::kUniformTexelBuffer:
      case DescriptorKind::kStorageTexelBuffer: {
        REPRISE_ASSIGN(view, texelBuffer(descriptor));
        break;
      }
      default: {
        REPRISE_ASSIGN(image, imageInfo(descriptor));
      }
    }
    const std::vector<VkDescriptorBufferInfo> buffers(descriptor.count, buffer);
    const std::vector<VkDescriptorImageInfo> images(descriptor.count, image);
    const std::vector<VkBufferView> views(descriptor.count, view);
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = made_.sets[descriptor.set];
    write.dstBinding = descriptor.binding;
    write.descriptorCount = descriptor.count;
    write.descriptorType = typeFor(descriptor);
    write.pBufferInfo = buffers.data();
    write.pImageInfo = images.data();
    write.pTexelBufferView = views.data();
    device_.fn.vkUpdateDescriptorSets(device_.device, 1, &write, 0, nullptr);
    return {};
  }

  Result<VkBuffer> block(const Descriptor& descriptor) {
    const bool stores = descriptor.kind == DescriptorKind::kStorageBlock;
    std::size_t size = std::max<std::size_t>(descriptor.size_bytes, 16) + (stores ? kUnsizedArrayBytes : 0);
    for (const BlockMember& member : descriptor.members) size = std::max<std::size_t>(size, (endOf(member) + 15) / 16 * 16);
    std::vector<std::byte> bytes = madeUpBlock(descriptor.members, size, values_);
    putIntegers(given_, descriptor, integerLimit(interface_), bytes);
    REPRISE_ASSIGN(Buffer made, createBuffer(device_, size, stores ? VK_BUFFER_USAGE_STORAGE_BUFFER_BIT : VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT));
    std::memcpy(made.mapped.data(), bytes.data(), size);
    made_.buffers.push_back(std::move(made));
    if (!stores) made_.moving.push_back({descriptor.members, bytes, made_.buffers.size() - 1});
    return made_.buffers.back().buffer.get();
  }

  Result<VkBufferView> texelBuffer(const Descriptor& descriptor) {
    const bool stores = descriptor.kind == DescriptorKind::kStorageTexelBuffer;
    constexpr std::size_t kSize = 256 * 16;
    std::vector<BlockMember> members(1);
    members[0].scalar = descriptor.texel;
    members[0].array_length = kSize / 4;
    members[0].array_stride = 4;
    const std::vector<std::byte> bytes = madeUpBlock(members, kSize, values_);
    REPRISE_ASSIGN(Buffer made, createBuffer(device_, kSize, stores ? VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT : VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT));
    std::memcpy(made.mapped.data(), bytes.data(), kSize);
    VkBufferViewCreateInfo create{VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
    create.buffer = made.buffer.get();
    create.format = descriptor.texel == ScalarKind::kFloat ? VK_FORMAT_R32G32B32A32_SFLOAT
                    : descriptor.texel == ScalarKind::kInt ? VK_FORMAT_R32G32B32A32_SINT
                                                           : VK_FORMAT_R32G32B32A32_UINT;
    create.range = VK_WHOLE_SIZE;
    made_.buffers.push_back(std::move(made));
    VkBufferView view = VK_NULL_HANDLE;
    REPRISE_VK(device_.fn.vkCreateBufferView(device_.device, &create, nullptr, &view));
    made_.views.emplace_back(device_.device, view, device_.fn.vkDestroyBufferView);
    return view;
  }

  Result<VkDescriptorImageInfo> imageInfo(const Descriptor& descriptor) {
    VkDescriptorImageInfo info{VK_NULL_HANDLE, VK_NULL_HANDLE, layoutOf(descriptor)};
    if (descriptor.kind != DescriptorKind::kSampler) {
      REPRISE_ASSIGN(Image made, madeUpImage(context_, commands_, descriptor, values_));
      info.imageView = made.view.get();
      made_.images.push_back(std::move(made));
    }
    if (descriptor.kind == DescriptorKind::kSampler || descriptor.kind == DescriptorKind::kCombinedImageSampler) {
      REPRISE_ASSIGN(info.sampler, sampler(descriptor));
    }
    return info;
  }

  Result<VkSampler> sampler(const Descriptor& descriptor) {
    VkSamplerCreateInfo create{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    const bool filters = descriptor.texel == ScalarKind::kFloat && !descriptor.compares;
    create.magFilter = create.minFilter = filters ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    create.mipmapMode = filters ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    create.maxLod = VK_LOD_CLAMP_NONE;
    create.compareEnable = descriptor.compares ? VK_TRUE : VK_FALSE;
    create.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    VkSampler made = VK_NULL_HANDLE;
    REPRISE_VK(device_.fn.vkCreateSampler(device_.device, &create, nullptr, &made));
    made_.samplers.emplace_back(device_.device, made, device_.fn.vkDestroySampler);
    return made;
  }

  const Context& context_;
  const DeviceView& device_;
  Commands& commands_;
  const ShaderInterface& interface_;
  const Descriptor* own_;
  const IntegerAssignment& given_;
  MadeUpValues& values_;
  MadeUpDescriptors made_;
};

}  // namespace

Result<MadeUpDescriptors> makeUpDescriptors(const Context& context, Commands& commands, const ShaderInterface& interface,
                                            const Descriptor* own, const IntegerAssignment& given, MadeUpValues& values) {
  return DescriptorMaker(context, commands, interface, own, given, values).make();
}

void moveBlocks(MadeUpDescriptors& descriptors, int frame) {
  for (const MovingBlock& block : descriptors.moving) {
    const std::vector<std::byte> bytes = blockAtFrame(block.members, block.bytes, frame);
    std::memcpy(descriptors.buffers[block.buffer].mapped.data(), bytes.data(), bytes.size());
  }
}

}  // namespace reprise
