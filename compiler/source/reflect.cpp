#include "compiler/source/reflect.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "compiler/source/stage_interface.h"
#include "runtime/package/interface_queries.h"

namespace reprise {
namespace {

Error interfaceError(const std::string& message) {
  return {ErrorKind::kInput, "source.interface", message, {}};
}

std::string slotText(const StageSlot& slot) {
  std::string text = slot.type + " \"" + slot.name + "\" at location " + std::to_string(slot.location);
  if (slot.component != 0) text += ", component " + std::to_string(slot.component);
  return text;
}

Result<void> matchSlots(const StageInterface& vertex, const StageInterface& fragment) {
  for (const StageSlot& input : fragment.inputs) {
    const auto output =
        std::find_if(vertex.outputs.begin(), vertex.outputs.end(), [&](const StageSlot& slot) {
          return slot.location == input.location && slot.component == input.component;
        });
    if (output != vertex.outputs.end() && output->type == input.type) continue;
    std::string found = "nothing there";
    if (output != vertex.outputs.end()) {
      found = slotText(*output);
    } else {
      const auto namesake = std::find_if(vertex.outputs.begin(), vertex.outputs.end(),
                                         [&](const StageSlot& slot) { return slot.name == input.name; });
      if (namesake != vertex.outputs.end()) found += ", but " + slotText(*namesake);
    }
    return interfaceError("the fragment shader reads " + slotText(input) + "; the vertex shader writes " +
                          found + "; location, component and type must agree");
  }
  return {};
}

bool isPrefix(const std::vector<BlockMember>& shorter, const std::vector<BlockMember>& longer) {
  return shorter.size() <= longer.size() && std::equal(shorter.begin(), shorter.end(), longer.begin());
}

std::string kindText(DescriptorKind kind) {
  switch (kind) {
    case DescriptorKind::kUniformBlock:
      return "uniform block";
    case DescriptorKind::kStorageBlock:
      return "storage block";
    case DescriptorKind::kCombinedImageSampler:
      return "combined image sampler";
    case DescriptorKind::kSampledImage:
      return "sampled image";
    case DescriptorKind::kSampler:
      return "sampler";
    case DescriptorKind::kStorageImage:
      return "storage image";
    case DescriptorKind::kUniformTexelBuffer:
      return "uniform texel buffer";
    case DescriptorKind::kStorageTexelBuffer:
      return "storage texel buffer";
  }
  return "descriptor";
}

std::string stageText(std::uint32_t stages) {
  if (stages == kStageVertex) return "the vertex shader";
  if (stages == kStageFragment) return "the fragment shader";
  return "both shaders";
}

// Whether one of them can be bound for both, as seen by Vulkan.
bool canAlias(const Descriptor& descriptor, const Descriptor& other) {
  return descriptor.stages == other.stages && descriptor.kind == other.kind && descriptor.dimension == other.dimension &&
         descriptor.texel == other.texel && descriptor.compares == other.compares && descriptor.multisampled == other.multisampled &&
         descriptor.storage_format == other.storage_format;
}

// An image and a sampler at one binding are the halves of a combined image sampler, in one shader or in two (Vulkan
// specification, "Shader Resource and Descriptor Type Correspondence"); nothing where the two are something else.
std::optional<Descriptor> joinHalves(const Descriptor& one, const Descriptor& other) {
  const bool first_is_sampler = one.kind == DescriptorKind::kSampler;
  const Descriptor &sampler = first_is_sampler ? one : other, &image = first_is_sampler ? other : one;
  const bool is_image = image.kind == DescriptorKind::kSampledImage || image.kind == DescriptorKind::kCombinedImageSampler;
  if (sampler.kind != DescriptorKind::kSampler || !is_image || image.count != sampler.count || image.multisampled) return std::nullopt;
  Descriptor joined = image;
  joined.kind = DescriptorKind::kCombinedImageSampler;
  joined.compares = image.compares || sampler.compares;
  joined.stages |= sampler.stages;
  return joined;
}

std::string quoted(const Descriptor& descriptor) { return "the " + kindText(descriptor.kind) + " \"" + descriptor.name + "\""; }

// HLSL numbers registers b, t, s and u each from 0, and they meet where nobody shifts them.
Error collision(const Descriptor& one, const Descriptor& other) {
  return {ErrorKind::kInput, "source.binding",
          quoted(one) + " and " + quoted(other) + " of " + stageText(one.stages & other.stages) + " are both at set " + std::to_string(one.set) + " binding " +
              std::to_string(one.binding) + "; give each a binding of its own: layout(binding = N) in GLSL, [[vk::binding(N, set)]] in HLSL and Slang, or "
              "-fvk-b-shift, -fvk-t-shift, -fvk-s-shift and -fvk-u-shift of dxc and slangc",
          {}};
}

// Merges `other` into `descriptor`, which has the same set and binding.
Result<void> mergeDescriptor(Descriptor& descriptor, const Descriptor& other, const ReflectOptions& options) {
  if (const std::optional<Descriptor> joined = joinHalves(descriptor, other)) {
    descriptor = *joined;
    return {};
  }
  if (options.any_bindings && canAlias(descriptor, other)) {
    const std::uint32_t count = std::max(descriptor.count, other.count);
    if (descriptor.size_bytes < other.size_bytes) descriptor = other;
    descriptor.count = count;
    return {};
  }
  if ((descriptor.stages & other.stages) != 0 && !options.any_bindings) return collision(descriptor, other);
  const bool longer = descriptor.members.size() < other.members.size();
  const bool members_agree =
      longer ? isPrefix(descriptor.members, other.members) : isPrefix(other.members, descriptor.members);
  const bool agree = descriptor.kind == other.kind && descriptor.dimension == other.dimension &&
                     descriptor.count == other.count && members_agree;
  if (!agree) {
    if ((descriptor.stages & other.stages) != 0) return collision(descriptor, other);
    return interfaceError("set " + std::to_string(descriptor.set) + " binding " +
                          std::to_string(descriptor.binding) + " is the " + kindText(descriptor.kind) +
                          " \"" + descriptor.name + "\" in " + stageText(descriptor.stages) + " and the " +
                          kindText(other.kind) + " \"" + other.name + "\" in " + stageText(other.stages) +
                          ", with another count or members; declare it the same in both");
  }
  if (longer) descriptor.members = other.members;
  descriptor.size_bytes = std::max(descriptor.size_bytes, other.size_bytes);
  descriptor.stages |= other.stages;
  return {};
}

Result<std::vector<Descriptor>> mergeDescriptors(const StageInterface& vertex,
                                                 const StageInterface& fragment, const ReflectOptions& options) {
  std::vector<Descriptor> merged;
  for (const StageInterface* stage : {&vertex, &fragment}) {
    for (const Descriptor& descriptor : stage->descriptors) {
      const auto same = std::find_if(merged.begin(), merged.end(), [&](const Descriptor& other) {
        return other.set == descriptor.set && other.binding == descriptor.binding;
      });
      if (same == merged.end()) {
        merged.push_back(descriptor);
      } else {
        REPRISE_TRY(mergeDescriptor(*same, descriptor, options));
      }
    }
  }
  std::sort(merged.begin(), merged.end(), [](const Descriptor& a, const Descriptor& b) {
    return std::tie(a.set, a.binding) < std::tie(b.set, b.binding);
  });
  for (std::size_t i = 0; i < merged.size() && !options.any_bindings; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (merged[i].name != merged[j].name) continue;
      return interfaceError("two bindings are both called \"" + merged[i].name +
                            "\"; scenarios bind by name: give them different names");
    }
  }
  return merged;
}

Result<void> mergePushConstants(const StageInterface& vertex, const StageInterface& fragment,
                                ShaderInterface& out) {
  out.push_constant_name =
      vertex.push_constant_name.empty() ? fragment.push_constant_name : vertex.push_constant_name;
  out.push_constants = vertex.push_constants;
  out.push_constant_members = vertex.push_constant_members;
  for (const BlockMember& member : fragment.push_constant_members) {
    const auto overlapping = std::find_if(
        out.push_constant_members.begin(), out.push_constant_members.end(), [&](const BlockMember& other) {
          return member.offset < endOf(other) && other.offset < endOf(member);
        });
    if (overlapping == out.push_constant_members.end()) {
      out.push_constant_members.push_back(member);
    } else if (*overlapping != member) {
      return interfaceError("the push constants \"" + overlapping->name + "\" of the vertex shader and \"" +
                            member.name + "\" of the fragment shader share bytes at offset " +
                            std::to_string(std::max(member.offset, overlapping->offset)) +
                            " but differ in name, type or offset; declare them the same or apart");
    }
  }
  std::sort(out.push_constant_members.begin(), out.push_constant_members.end(),
            [](const BlockMember& a, const BlockMember& b) { return a.offset < b.offset; });
  for (const PushConstantRange& range : fragment.push_constants) {
    if (out.push_constants.empty()) {
      out.push_constants.push_back(range);
      continue;
    }
    PushConstantRange& first = out.push_constants.front();
    const bool overlap =
        range.offset < first.offset + first.size_bytes && first.offset < range.offset + range.size_bytes;
    if (overlap) {
      const std::uint32_t end = std::max(first.offset + first.size_bytes, range.offset + range.size_bytes);
      first.offset = std::min(first.offset, range.offset);
      first.size_bytes = end - first.offset;
      first.stages |= range.stages;
    } else {
      out.push_constants.push_back(range);
    }
  }
  return {};
}

}  // namespace

Result<ShaderInterface> reflectInterface(std::span<const std::uint32_t> vertex_words,
                                         std::span<const std::uint32_t> fragment_words, const ReflectOptions& options) {
  REPRISE_ASSIGN(StageInterface vertex, reflectStage(vertex_words, ShaderStage::kVertex, options));
  REPRISE_ASSIGN(StageInterface fragment, reflectStage(fragment_words, ShaderStage::kFragment, options));
  REPRISE_TRY(matchSlots(vertex, fragment));
  ShaderInterface out;
  out.vertex_inputs = std::move(vertex.vertex_inputs);
  out.outputs = std::move(fragment.colors);
  REPRISE_ASSIGN(out.descriptors, mergeDescriptors(vertex, fragment, options));
  REPRISE_TRY(mergePushConstants(vertex, fragment, out));
  out.writes_depth = fragment.writes_depth;
  out.discards = fragment.discards;
  return out;
}

}  // namespace reprise
