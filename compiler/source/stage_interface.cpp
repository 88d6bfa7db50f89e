#include "compiler/source/stage_interface.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <spirv_cross/spirv_cross.hpp>
#include <utility>

#include "compiler/source/block_members.h"
#include "compiler/source/color_outputs.h"
#include "compiler/source/image_formats.h"

namespace reprise {
namespace {

using spirv_cross::Compiler;
using spirv_cross::Resource;
using spirv_cross::SPIRType;

constexpr std::uint32_t kUnsizedDescriptors = 16;

Error unsupported(const std::string& message) {
  return {ErrorKind::kInput, "source.unsupported", message, {}};
}

std::string typeText(const SPIRType& type) {
  std::string scalar, prefix;
  switch (type.basetype) {
    case SPIRType::Float: scalar = "float"; break;
    case SPIRType::Int: scalar = "int", prefix = "i"; break;
    case SPIRType::UInt: scalar = "uint", prefix = "u"; break;
    case SPIRType::Double: scalar = "double", prefix = "d"; break;
    case SPIRType::Half: scalar = "float16_t", prefix = "f16"; break;
    case SPIRType::Int64: scalar = "int64_t", prefix = "i64"; break;
    case SPIRType::UInt64: scalar = "uint64_t", prefix = "u64"; break;
    case SPIRType::Short: scalar = "int16_t", prefix = "i16"; break;
    case SPIRType::UShort: scalar = "uint16_t", prefix = "u16"; break;
    default: return "an unknown type";
  }
  return type.vecsize == 1 ? scalar : prefix + "vec" + std::to_string(type.vecsize);
}

std::optional<ScalarKind> scalarOf(const SPIRType& type) {
  switch (type.basetype) {
    case SPIRType::Float:
      return ScalarKind::kFloat;
    case SPIRType::Int:
      return ScalarKind::kInt;
    case SPIRType::UInt:
      return ScalarKind::kUint;
    default:
      return std::nullopt;
  }
}

std::uint32_t arrayCount(const Compiler& compiler, const SPIRType& type, std::size_t dimension) {
  return type.array_size_literal[dimension] ? type.array[dimension]
                                            : compiler.get_constant(type.array[dimension]).scalar();
}

// Adds the locations of a value and returns the first location after it.
std::uint32_t addSlots(const Compiler& compiler, const SPIRType& type, StageSlot slot,
                       std::vector<StageSlot>& slots) {
  std::uint32_t elements = 1;
  for (std::size_t i = 0; i < type.array.size(); ++i) elements *= arrayCount(compiler, type, i);
  elements = std::min(elements, 256u);  // more locations than any device has
  if (type.basetype == SPIRType::Struct) {
    const std::string outer = slot.name;
    for (std::uint32_t element = 0; element < elements; ++element) {
      for (std::uint32_t i = 0; i < type.member_types.size(); ++i) {
        if (compiler.has_member_decoration(type.self, i, spv::DecorationBuiltIn)) continue;
        if (compiler.has_member_decoration(type.self, i, spv::DecorationLocation)) {
          slot.location = compiler.get_member_decoration(type.self, i, spv::DecorationLocation);
        }
        slot.component = compiler.get_member_decoration(type.self, i, spv::DecorationComponent);
        slot.name = outer + "." + compiler.get_member_name(type.self, i);
        slot.location = addSlots(compiler, compiler.get_type(type.member_types[i]), slot, slots);
      }
    }
    return slot.location;
  }
  slot.type = typeText(type);
  // 64-bit vectors of more than two components take two locations.
  const std::uint32_t step = type.width == 64 && type.vecsize > 2 ? 2 : 1;
  for (std::uint32_t i = 0; i < elements * type.columns; ++i) {
    slots.push_back(slot);
    slot.location += step;
  }
  return slot.location;
}

std::string nameOfVariable(const Compiler& compiler, const Resource& resource) {
  const std::string& name = compiler.get_name(resource.id);
  return name.empty() ? resource.name : name;
}

std::vector<StageSlot> slotsOf(const Compiler& compiler,
                               const spirv_cross::SmallVector<Resource>& resources) {
  std::vector<StageSlot> slots;
  for (const Resource& resource : resources) {
    StageSlot slot;
    slot.name = nameOfVariable(compiler, resource);
    slot.location = compiler.get_decoration(resource.id, spv::DecorationLocation);
    slot.component = compiler.get_decoration(resource.id, spv::DecorationComponent);
    addSlots(compiler, compiler.get_type(resource.type_id), slot, slots);
  }
  return slots;
}

Result<std::vector<VertexInput>> vertexInputs(const Compiler& compiler,
                                              const spirv_cross::SmallVector<Resource>& resources) {
  std::vector<VertexInput> inputs;
  for (const Resource& resource : resources) {
    const SPIRType& type = compiler.get_type(resource.type_id);
    VertexInput input;
    input.name = nameOfVariable(compiler, resource);
    input.location = compiler.get_decoration(resource.id, spv::DecorationLocation);
    input.components = static_cast<int>(type.vecsize);
    const std::optional<ScalarKind> scalar = scalarOf(type);
    const bool plain = scalar && type.width == 32 && type.columns == 1 && type.array.empty() &&
                       compiler.get_decoration(resource.id, spv::DecorationComponent) == 0;
    if (!plain) {
      return unsupported("the vertex input \"" + input.name +
                         "\" is no scalar or vector of 32-bit floats or integers with a location of its own");
    }
    input.scalar = *scalar;
    inputs.push_back(input);
  }
  std::sort(inputs.begin(), inputs.end(),
            [](const VertexInput& a, const VertexInput& b) { return a.location < b.location; });
  return inputs;
}

std::string blockName(const Compiler& compiler, const Resource& resource) {
  const std::string& type_name = compiler.get_name(resource.base_type_id);
  if (!type_name.empty()) return type_name;
  const std::string& name = compiler.get_name(resource.id);
  if (!name.empty()) return name;
  return "block_" + std::to_string(compiler.get_decoration(resource.id, spv::DecorationDescriptorSet)) + "_" +
         std::to_string(compiler.get_decoration(resource.id, spv::DecorationBinding));
}

// What SPIRV-Cross tells of one descriptor, without what depends on its kind.
Result<Descriptor> commonDescriptor(const Compiler& compiler, const Resource& resource, std::uint32_t stage_bit,
                                    const ReflectOptions& options) {
  Descriptor descriptor;
  descriptor.name = nameOfVariable(compiler, resource);
  descriptor.set = compiler.get_decoration(resource.id, spv::DecorationDescriptorSet);
  descriptor.binding = compiler.get_decoration(resource.id, spv::DecorationBinding);
  descriptor.stages = stage_bit;
  const SPIRType& type = compiler.get_type(resource.type_id);
  if (type.array.size() > 1 && !options.any_arrays)
    return unsupported("\"" + descriptor.name + "\" is an array of arrays of descriptors");
  for (std::size_t i = 0; i < type.array.size(); ++i) descriptor.count *= arrayCount(compiler, type, i);
  if (descriptor.count == 0 && options.any_arrays) descriptor.count = kUnsizedDescriptors;
  if (descriptor.count == 0)
    return unsupported("\"" + descriptor.name + "\" is a descriptor array without a size");
  return descriptor;
}

std::optional<ImageDimension> dimensionOf(const SPIRType::ImageType& image) {
  switch (image.dim) {
    case spv::Dim1D:
      return image.arrayed ? ImageDimension::k1DArray : ImageDimension::k1D;
    case spv::Dim2D:
      return image.arrayed ? ImageDimension::k2DArray : ImageDimension::k2D;
    case spv::Dim3D:
      return ImageDimension::k3D;
    case spv::DimCube:
      return image.arrayed ? ImageDimension::kCubeArray : ImageDimension::kCube;
    default:
      return std::nullopt;
  }
}

class DescriptorList {
 public:
  DescriptorList(const Compiler& compiler, std::uint32_t stage_bit, const ReflectOptions& options)
      : compiler_(compiler), stage_bit_(stage_bit), options_(options) {}

  Result<void> addBlocks(const spirv_cross::SmallVector<Resource>& resources, DescriptorKind kind) {
    for (const Resource& resource : resources) {
      REPRISE_ASSIGN(Descriptor descriptor, commonDescriptor(compiler_, resource, stage_bit_, options_));
      descriptor.kind = kind;
      descriptor.name = blockName(compiler_, resource);
      REPRISE_ASSIGN(descriptor.members, flattenBlock(compiler_, resource.base_type_id, descriptor.name, options_));
      const SPIRType& type = compiler_.get_type(resource.base_type_id);
      const auto size = static_cast<std::uint32_t>(compiler_.get_declared_struct_size(type));
      descriptor.size_bytes = (size + 15) / 16 * 16;
      list_.push_back(std::move(descriptor));
    }
    return {};
  }

  Result<void> addImages(const spirv_cross::SmallVector<Resource>& resources, DescriptorKind kind) {
    for (const Resource& resource : resources) {
      REPRISE_ASSIGN(Descriptor descriptor, commonDescriptor(compiler_, resource, stage_bit_, options_));
      descriptor.kind = kind;
      if (kind != DescriptorKind::kSampler) {
        const SPIRType::ImageType& image = compiler_.get_type(resource.base_type_id).image;
        descriptor.texel = scalarOf(compiler_.get_type(image.type)).value_or(ScalarKind::kFloat);
        descriptor.compares = image.depth;
        descriptor.multisampled = image.ms;
        if (kind == DescriptorKind::kStorageImage) descriptor.storage_format = formatName(static_cast<std::uint32_t>(image.format));
        if (image.dim == spv::DimBuffer) {
          const bool stores = kind == DescriptorKind::kStorageImage;
          descriptor.kind = stores ? DescriptorKind::kStorageTexelBuffer : DescriptorKind::kUniformTexelBuffer;
        } else if (const std::optional<ImageDimension> dimension = dimensionOf(image)) {
          descriptor.dimension = *dimension;
        } else {
          return unsupported("\"" + descriptor.name + "\" is an image of a dimension that is not supported");
        }
      }
      list_.push_back(std::move(descriptor));
    }
    return {};
  }

  std::vector<Descriptor> take() { return std::move(list_); }

 private:
  const Compiler& compiler_;
  std::uint32_t stage_bit_;
  ReflectOptions options_;
  std::vector<Descriptor> list_;
};

Result<std::vector<Descriptor>> descriptorsOf(const Compiler& compiler,
                                              const spirv_cross::ShaderResources& resources,
                                              std::uint32_t stage_bit, const ReflectOptions& options) {
  if (!resources.subpass_inputs.empty())
    return Error{ErrorKind::kRefused, "shader.subpass_input",
                 "the shader reads the subpass input \"" + nameOfVariable(compiler, resources.subpass_inputs.front()) +
                     "\", which passes of a recipe do not have", {}};
  for (const auto* refused : {&resources.atomic_counters, &resources.acceleration_structures, &resources.shader_record_buffers}) {
    if (!refused->empty()) {
      return Error{ErrorKind::kRefused, "shader.ray_tracing",
                   "\"" + nameOfVariable(compiler, refused->front()) + "\" is an atomic counter or a ray-tracing resource", {}};
    }
  }
  DescriptorList list(compiler, stage_bit, options);
  REPRISE_TRY(list.addBlocks(resources.uniform_buffers, DescriptorKind::kUniformBlock));
  REPRISE_TRY(list.addBlocks(resources.storage_buffers, DescriptorKind::kStorageBlock));
  REPRISE_TRY(list.addImages(resources.sampled_images, DescriptorKind::kCombinedImageSampler));
  REPRISE_TRY(list.addImages(resources.separate_images, DescriptorKind::kSampledImage));
  REPRISE_TRY(list.addImages(resources.separate_samplers, DescriptorKind::kSampler));
  REPRISE_TRY(list.addImages(resources.storage_images, DescriptorKind::kStorageImage));
  return list.take();
}

Result<void> addPushConstants(const Compiler& compiler, const spirv_cross::SmallVector<Resource>& blocks,
                              const ReflectOptions& options, StageInterface& out) {
  if (blocks.empty()) return {};
  const Resource& block = blocks.front();
  out.push_constant_name = blockName(compiler, block);
  REPRISE_ASSIGN(out.push_constant_members,
                 flattenBlock(compiler, block.base_type_id, out.push_constant_name, options));
  if (out.push_constant_members.empty()) return {};
  PushConstantRange range;
  range.offset = out.push_constant_members.front().offset;
  for (const BlockMember& member : out.push_constant_members)
    range.offset = std::min(range.offset, member.offset);
  const auto end =
      static_cast<std::uint32_t>(compiler.get_declared_struct_size(compiler.get_type(block.base_type_id)));
  range.size_bytes = (end - range.offset + 3) / 4 * 4;
  out.push_constants.push_back(range);
  return {};
}

bool hasDiscard(std::span<const std::uint32_t> words) {
  for (std::size_t at = 5; at < words.size() && words[at] >> 16 != 0; at += words[at] >> 16) {
    const std::uint32_t opcode = words[at] & 0xffffu;
    if (opcode == spv::OpKill || opcode == spv::OpTerminateInvocation ||
        opcode == spv::OpDemoteToHelperInvocation) {
      return true;
    }
  }
  return false;
}

Result<void> chooseEntryPoint(Compiler& compiler, spv::ExecutionModel model, const char* stage) {
  std::optional<std::string> chosen;
  for (const spirv_cross::EntryPoint& entry : compiler.get_entry_points_and_stages()) {
    if (entry.execution_model == model && (!chosen || entry.name == "main")) chosen = entry.name;
  }
  if (!chosen) {
    return Error{
        ErrorKind::kInput, "source.stage", std::string("the module has no ") + stage + " entry point", {}};
  }
  compiler.set_entry_point(*chosen, model);
  return {};
}

Result<StageInterface> reflectWith(Compiler& compiler, ShaderStage stage, const ReflectOptions& options) {
  const bool vertex = stage == ShaderStage::kVertex;
  REPRISE_TRY(chooseEntryPoint(compiler, vertex ? spv::ExecutionModelVertex : spv::ExecutionModelFragment,
                               nameOf(stage)));
  const std::uint32_t stage_bit = vertex ? kStageVertex : kStageFragment;
  const spirv_cross::ShaderResources active =
      compiler.get_shader_resources(compiler.get_active_interface_variables());
  const spirv_cross::ShaderResources declared = compiler.get_shader_resources();
  StageInterface out;
  out.inputs = slotsOf(compiler, active.stage_inputs);
  out.outputs = slotsOf(compiler, declared.stage_outputs);
  if (vertex) {
    REPRISE_ASSIGN(out.vertex_inputs, vertexInputs(compiler, active.stage_inputs));
  } else {
    REPRISE_ASSIGN(out.colors, colorOutputs(compiler, active));
    out.writes_depth = compiler.get_execution_mode_bitset().get(spv::ExecutionModeDepthReplacing);
  }
  REPRISE_ASSIGN(out.descriptors, descriptorsOf(compiler, active, stage_bit, options));
  REPRISE_TRY(addPushConstants(compiler, active.push_constant_buffers, options, out));
  for (PushConstantRange& range : out.push_constants) range.stages = stage_bit;
  return out;
}

}  // namespace

Result<StageInterface> reflectStage(std::span<const std::uint32_t> words, ShaderStage stage, const ReflectOptions& options) {
  try {
    Compiler compiler(words.data(), words.size());
    REPRISE_ASSIGN(StageInterface out, reflectWith(compiler, stage, options));
    out.discards = stage == ShaderStage::kFragment && hasDiscard(words);
    return out;
  } catch (const std::exception& thrown) {
    return Error{ErrorKind::kInput,
                 "source.invalid",
                 std::string("SPIRV-Cross cannot read the ") + nameOf(stage) + " module: " + thrown.what(),
                 {}};
  }
}

}  // namespace reprise
