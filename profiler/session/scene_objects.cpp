#include "profiler/session/scene_objects.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "profiler/scenario/standard_names.h"
#include "profiler/scene/mesh.h"
#include "profiler/scene/disc_texture.h"
#include "profiler/scene/texture.h"
#include "profiler/session/model_textures.h"
#include "runtime/playback/formats.h"
#include "runtime/vulkan/upload.h"

namespace reprise {
namespace {

constexpr VkShaderStageFlags kBothStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
constexpr VkDeviceSize kBlockAlignment = 256;

Result<Buffer> bufferWith(const DeviceView& device, const void* bytes, std::size_t size, VkBufferUsageFlags usage) {
  REPRISE_ASSIGN(Buffer buffer, createBuffer(device, std::max<std::size_t>(size, 4), usage));
  std::memcpy(buffer.mapped.data(), bytes, size);
  return buffer;
}

// The winding of mirrored parts is turned back, so that their fronts are fronts.
Mesh meshOf(const Scenario& scenario, const Object& object) {
  if (!object.part) return buildMesh(object.mesh);
  const GltfScene& scene = *scenario.models[object.part->model].scene;
  const GltfInstance& instance = scene.instances[object.part->instance];
  Mesh mesh{primitiveOf(scene, instance).vertices, primitiveOf(scene, instance).indices};
  for (std::size_t i = 0; instance.mirrored && i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  return mesh;
}

std::vector<DeformVertex> deformOf(const Scenario& scenario, const Object& object, std::size_t vertices) {
  std::vector<DeformVertex> deform;
  if (object.part) {
    const GltfScene& scene = *scenario.models[object.part->model].scene;
    deform = primitiveOf(scene, scene.instances[object.part->instance]).deform;
  }
  deform.resize(vertices);
  return deform;
}

class SceneBuilder {
 public:
  SceneBuilder(const Context& context, Commands& commands, const SceneSource& source)
      : context_(context), device_(context.view()), commands_(commands), scenario_(*source.scenario), interface_(*source.interface),
        textures_(*source.textures) {}

  Result<SceneObjects> build() {
    REPRISE_TRY(supported());
    REPRISE_TRY(uploadMeshes());
    REPRISE_TRY(createLayouts());
    REPRISE_TRY(createBlocks());
    listPushConstants();
    REPRISE_TRY(uploadTextures());
    REPRISE_TRY(createSets());
    return std::move(scene_);
  }

 private:
  Result<void> supported() const {
    for (const Descriptor& descriptor : interface_.descriptors)
      if (descriptor.count != 1 || (descriptor.kind != DescriptorKind::kUniformBlock && descriptor.kind != DescriptorKind::kCombinedImageSampler) ||
          (descriptor.kind == DescriptorKind::kCombinedImageSampler && descriptor.dimension != ImageDimension::k2D))
        return Error{ErrorKind::kInput, "scenario.unsupported",
                     "the profiler cannot fill '" + descriptor.name + "': version 1 knows uniform blocks and 2D combined image samplers", {}};
    return {};
  }

  Result<void> uploadMeshes() {
    for (const Object& object : scenario_.objects) {
      const Mesh mesh = meshOf(scenario_, object);
      ObjectBuffers buffers;
      REPRISE_ASSIGN(buffers.vertices, bufferWith(device_, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT));
      REPRISE_ASSIGN(buffers.indices, bufferWith(device_, mesh.indices.data(), mesh.indices.size() * 4, VK_BUFFER_USAGE_INDEX_BUFFER_BIT));
      if (readsDeformation(interface_)) {
        const std::vector<DeformVertex> deform = deformOf(scenario_, object, mesh.vertices.size());
        REPRISE_ASSIGN(buffers.deform, bufferWith(device_, deform.data(), deform.size() * sizeof(DeformVertex), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT));
      }
      buffers.index_count = static_cast<std::uint32_t>(mesh.indices.size());
      scene_.objects.push_back(std::move(buffers));
    }
    return {};
  }

  Result<void> createLayouts() {
    std::uint32_t sets = 0;
    for (const Descriptor& descriptor : interface_.descriptors) sets = std::max(sets, descriptor.set + 1);
    for (std::uint32_t set = 0; set < sets; ++set) {
      std::vector<VkDescriptorSetLayoutBinding> bindings;
      for (const Descriptor& descriptor : interface_.descriptors)
        if (descriptor.set == set) bindings.push_back({descriptor.binding, descriptorType(descriptor.kind), 1, kBothStages, nullptr});
      VkDescriptorSetLayoutCreateInfo create{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
      create.bindingCount = static_cast<std::uint32_t>(bindings.size());
      create.pBindings = bindings.data();
      VkDescriptorSetLayout layout = VK_NULL_HANDLE;
      REPRISE_VK(device_.fn.vkCreateDescriptorSetLayout(device_.device, &create, nullptr, &layout));
      scene_.set_layouts.emplace_back(device_.device, layout, device_.fn.vkDestroyDescriptorSetLayout);
    }
    return {};
  }

  Result<void> createBlocks() {
    for (const Descriptor& descriptor : interface_.descriptors) {
      if (descriptor.kind != DescriptorKind::kUniformBlock) continue;
      BlockSlots block;
      block.descriptor = &descriptor;
      block.stride = (descriptor.size_bytes + 16 + kBlockAlignment - 1) / kBlockAlignment * kBlockAlignment;
      REPRISE_ASSIGN(block.buffer, createBuffer(device_, block.stride * scene_.objects.size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT));
      scene_.blocks.push_back(std::move(block));
    }
    return {};
  }

  void listPushConstants() {
    for (const PushConstantRange& range : interface_.push_constants) {
      scene_.push_ranges.push_back({range.stages, range.offset, range.size_bytes});
      scene_.push_bytes = std::max(scene_.push_bytes, range.offset + range.size_bytes);
    }
  }

  Result<void> uploadTextures() {
    for (const TextureSpec& spec : scenario_.textures) {
      REPRISE_ASSIGN(const TextureImage image, spec.kind == TextureKind::kDiscs ? buildDiscTexture(scenario_, spec) : buildTexture(spec));
      REPRISE_TRY(upload(spec, image));
    }
    models_ = listModelTextures(scenario_, interface_);
    for (const ModelTexture& texture : models_.textures) {
      Result<TextureImage> image = texture.image ? decodeTexture(texture.spec, texture.image->bytes) : buildTexture(texture.spec);
      if (!image.ok()) return image.error();
      REPRISE_TRY(upload(texture.spec, *image));
    }
    return {};
  }

  Result<void> upload(const TextureSpec& spec, const TextureImage& image) {
    UploadDescription description;
    description.extent = {static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height)};
    description.mipmaps = spec.mipmaps;
    if (image.high_dynamic_range) {
      description.format = VK_FORMAT_R32G32B32A32_SFLOAT;
      REPRISE_ASSIGN(Image uploaded, uploadTexture(context_, commands_, description, std::as_bytes(std::span(image.rgba))));
      scene_.textures.push_back(std::move(uploaded));
    } else {
      description.format = spec.srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM;
      std::vector<std::uint8_t> bytes(image.rgba.size());
      for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(std::lround(std::clamp(image.rgba[i], 0.0f, 1.0f) * 255));
      REPRISE_ASSIGN(Image uploaded, uploadTexture(context_, commands_, description, std::as_bytes(std::span(bytes))));
      scene_.textures.push_back(std::move(uploaded));
    }
    return createSampler(spec);
  }

  Result<void> createSampler(const TextureSpec& spec) {
    VkSamplerCreateInfo create{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    create.magFilter = create.minFilter = spec.linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    create.mipmapMode = spec.linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    create.addressModeU = create.addressModeV = create.addressModeW =
        spec.repeat ? VK_SAMPLER_ADDRESS_MODE_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    create.maxLod = VK_LOD_CLAMP_NONE;
    VkSampler sampler = VK_NULL_HANDLE;
    REPRISE_VK(device_.fn.vkCreateSampler(device_.device, &create, nullptr, &sampler));
    scene_.samplers.emplace_back(device_.device, sampler, device_.fn.vkDestroySampler);
    return {};
  }

  Result<void> createSets() {
    const auto count = static_cast<std::uint32_t>(scene_.set_layouts.size() * scene_.objects.size());
    scene_.sets.resize(scene_.objects.size());
    if (count == 0) return {};
    const auto per_kind = static_cast<std::uint32_t>(interface_.descriptors.size() * scene_.objects.size());
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, std::max(per_kind, 1u)},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, std::max(per_kind, 1u)}};
    VkDescriptorPoolCreateInfo create{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    create.maxSets = count;
    create.poolSizeCount = 2;
    create.pPoolSizes = sizes;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    REPRISE_VK(device_.fn.vkCreateDescriptorPool(device_.device, &create, nullptr, &pool));
    scene_.pool = {device_.device, pool, device_.fn.vkDestroyDescriptorPool};
    std::vector<VkDescriptorSetLayout> layouts;
    for (const auto& layout : scene_.set_layouts) layouts.push_back(layout.get());
    for (std::size_t object = 0; object < scene_.objects.size(); ++object) {
      scene_.sets[object].resize(layouts.size());
      VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
      allocate.descriptorPool = pool;
      allocate.descriptorSetCount = static_cast<std::uint32_t>(layouts.size());
      allocate.pSetLayouts = layouts.data();
      REPRISE_VK(device_.fn.vkAllocateDescriptorSets(device_.device, &allocate, scene_.sets[object].data()));
      writeSets(object);
    }
    return {};
  }

  void writeSets(std::size_t object) {
    std::size_t block = 0;
    for (const Descriptor& descriptor : interface_.descriptors) {
      VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
      write.dstSet = scene_.sets[object][descriptor.set];
      write.dstBinding = descriptor.binding;
      write.descriptorCount = 1;
      write.descriptorType = descriptorType(descriptor.kind);
      VkDescriptorBufferInfo buffer{};
      VkDescriptorImageInfo image{};
      if (descriptor.kind == DescriptorKind::kUniformBlock) {
        const BlockSlots& slots = scene_.blocks[block++];
        buffer = {slots.buffer.buffer.get(), slots.stride * object, slots.stride};
        write.pBufferInfo = &buffer;
      } else if (const auto of_pass = passTexture(scenario_, textures_, descriptor)) {
        image = *of_pass;
        write.pImageInfo = &image;
      } else {
        const std::size_t index = textureIndex(descriptor.name, object);
        image = {scene_.samplers[index].get(), scene_.textures[index].view.get(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        write.pImageInfo = &image;
      }
      device_.fn.vkUpdateDescriptorSets(device_.device, 1, &write, 0, nullptr);
    }
  }

  std::size_t textureIndex(const std::string& name, std::size_t object) const {
    const auto of_models = models_.used.find(name);
    if (of_models != models_.used.end()) return scenario_.textures.size() + of_models->second[object];
    const auto texture = std::find_if(scenario_.textures.begin(), scenario_.textures.end(), [&](const TextureSpec& spec) { return spec.name == name; });
    REPRISE_CHECK(texture != scenario_.textures.end(), name);
    return static_cast<std::size_t>(texture - scenario_.textures.begin());
  }

  const Context& context_;
  const DeviceView& device_;
  Commands& commands_;
  const Scenario& scenario_;
  const ShaderInterface& interface_;
  const PassTextures& textures_;
  SceneObjects scene_;
  ModelTextures models_;
};

}  // namespace

bool readsDeformation(const ShaderInterface& interface) {
  const std::vector<std::string>& names = deformInputs();
  return std::any_of(interface.vertex_inputs.begin(), interface.vertex_inputs.end(),
                     [&](const VertexInput& input) { return std::find(names.begin(), names.end(), input.name) != names.end(); });
}

Result<SceneObjects> createSceneObjects(const Context& context, Commands& commands, const SceneSource& source) {
  return SceneBuilder(context, commands, source).build();
}

}  // namespace reprise
