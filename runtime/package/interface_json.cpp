// ShaderInterface <-> JSON.
#include "runtime/package/json.h"
#include "runtime/package/json_values.h"
#include "runtime/package/package.h"

namespace reprise {
namespace {

using nlohmann::json;

const EnumNames<ScalarKind> kScalars = {
    {ScalarKind::kFloat, "float"}, {ScalarKind::kInt, "int"}, {ScalarKind::kUint, "uint"}};
const EnumNames<DescriptorKind> kDescriptors = {{DescriptorKind::kUniformBlock, "uniform_block"},
                                                {DescriptorKind::kStorageBlock, "storage_block"},
                                                {DescriptorKind::kCombinedImageSampler, "combined_image_sampler"},
                                                {DescriptorKind::kSampledImage, "sampled_image"},
                                                {DescriptorKind::kSampler, "sampler"},
                                                {DescriptorKind::kStorageImage, "storage_image"},
                                                {DescriptorKind::kUniformTexelBuffer, "uniform_texel_buffer"},
                                                {DescriptorKind::kStorageTexelBuffer, "storage_texel_buffer"}};
const EnumNames<ImageDimension> kDimensions = {
    {ImageDimension::kNone, "none"}, {ImageDimension::k1D, "1d"},          {ImageDimension::k2D, "2d"},
    {ImageDimension::k3D, "3d"},     {ImageDimension::kCube, "cube"},      {ImageDimension::k1DArray, "1d_array"},
    {ImageDimension::k2DArray, "2d_array"}, {ImageDimension::kCubeArray, "cube_array"}};

json toJson(const BlockMember& member) {
  return {{"name", member.name}, {"scalar", enumText(kScalars, member.scalar)}, {"rows", member.rows},
          {"columns", member.columns}, {"offset", member.offset}, {"matrix_stride", member.matrix_stride},
          {"row_major", member.row_major}, {"array_length", member.array_length}, {"array_stride", member.array_stride}};
}

BlockMember memberFrom(const json& from) {
  return {textAt(from, "name"), enumAt(from, "scalar", kScalars), integerAt<int>(from, "rows"), integerAt<int>(from, "columns"),
          integerAt<std::uint32_t>(from, "offset"), integerAt<std::uint32_t>(from, "matrix_stride"), boolAt(from, "row_major"),
          integerAt<std::uint32_t>(from, "array_length"), integerAt<std::uint32_t>(from, "array_stride")};
}

json membersJson(const std::vector<BlockMember>& members) {
  return listJson(members, [](const BlockMember& member) { return toJson(member); });
}

json toJson(const Descriptor& descriptor) {
  return {{"name", descriptor.name}, {"set", descriptor.set}, {"binding", descriptor.binding}, {"count", descriptor.count},
          {"kind", enumText(kDescriptors, descriptor.kind)}, {"dimension", enumText(kDimensions, descriptor.dimension)},
          {"stages", descriptor.stages}, {"size_bytes", descriptor.size_bytes}, {"members", membersJson(descriptor.members)},
          {"texel", enumText(kScalars, descriptor.texel)}, {"compares", descriptor.compares}, {"multisampled", descriptor.multisampled},
          {"storage_format", descriptor.storage_format}};
}

Descriptor descriptorFrom(const json& from) {
  return {textAt(from, "name"), integerAt<std::uint32_t>(from, "set"), integerAt<std::uint32_t>(from, "binding"),
          integerAt<std::uint32_t>(from, "count"), enumAt(from, "kind", kDescriptors), enumAt(from, "dimension", kDimensions),
          integerAt<std::uint32_t>(from, "stages"), integerAt<std::uint32_t>(from, "size_bytes"),
          listAt<BlockMember>(from, "members", memberFrom), enumAt(from, "texel", kScalars), boolAt(from, "compares"),
          boolAt(from, "multisampled"), textAt(from, "storage_format")};
}

json toJson(const PushConstantRange& range) {
  return {{"stages", range.stages}, {"offset", range.offset}, {"size_bytes", range.size_bytes}};
}

PushConstantRange rangeFrom(const json& from) {
  return {integerAt<std::uint32_t>(from, "stages"), integerAt<std::uint32_t>(from, "offset"),
          integerAt<std::uint32_t>(from, "size_bytes")};
}

// VertexInput and FragmentOutput have the same members.
template <typename Place>
json placeJson(const Place& place) {
  return {{"name", place.name}, {"location", place.location}, {"scalar", enumText(kScalars, place.scalar)},
          {"components", place.components}};
}

template <typename Place>
Place placeFrom(const json& from) {
  return {textAt(from, "name"), integerAt<std::uint32_t>(from, "location"), enumAt(from, "scalar", kScalars),
          integerAt<int>(from, "components")};
}

}  // namespace

json interfaceJson(const ShaderInterface& interface) {
  return {{"vertex_inputs", listJson(interface.vertex_inputs, placeJson<VertexInput>)},
          {"outputs", listJson(interface.outputs, placeJson<FragmentOutput>)},
          {"descriptors", listJson(interface.descriptors, [](const Descriptor& descriptor) { return toJson(descriptor); })},
          {"push_constant_name", interface.push_constant_name},
          {"push_constants", listJson(interface.push_constants, [](const PushConstantRange& range) { return toJson(range); })},
          {"push_constant_members", membersJson(interface.push_constant_members)},
          {"writes_depth", interface.writes_depth}, {"discards", interface.discards}};
}

ShaderInterface interfaceFrom(const json& from) {
  ShaderInterface interface;
  interface.vertex_inputs = listAt<VertexInput>(from, "vertex_inputs", placeFrom<VertexInput>);
  interface.outputs = listAt<FragmentOutput>(from, "outputs", placeFrom<FragmentOutput>);
  interface.descriptors = listAt<Descriptor>(from, "descriptors", descriptorFrom);
  interface.push_constant_name = textAt(from, "push_constant_name");
  interface.push_constants = listAt<PushConstantRange>(from, "push_constants", rangeFrom);
  interface.push_constant_members = listAt<BlockMember>(from, "push_constant_members", memberFrom);
  interface.writes_depth = boolAt(from, "writes_depth");
  interface.discards = boolAt(from, "discards");
  return interface;
}

std::string interfaceToJson(const ShaderInterface& interface) { return jsonText(interfaceJson(interface), 2); }

Result<ShaderInterface> interfaceFromJson(const std::string& text) {
  try {
    return interfaceFrom(parseJson(text));
  } catch (const std::exception& failure) {
    return Error{ErrorKind::kInput, "package.manifest", std::string("this is no shader interface: ") + failure.what(), {}};
  }
}

}  // namespace reprise
