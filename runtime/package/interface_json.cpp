// ShaderInterface <-> JSON.
#include <nlohmann/json.hpp>

#include "runtime/package/json.h"
#include "runtime/package/package.h"

namespace reprise {

using nlohmann::json;

NLOHMANN_JSON_SERIALIZE_ENUM(ScalarKind, {{ScalarKind::kFloat, "float"}, {ScalarKind::kInt, "int"}, {ScalarKind::kUint, "uint"}})
NLOHMANN_JSON_SERIALIZE_ENUM(DescriptorKind, {{DescriptorKind::kUniformBlock, "uniform_block"},
                                              {DescriptorKind::kStorageBlock, "storage_block"},
                                              {DescriptorKind::kCombinedImageSampler, "combined_image_sampler"},
                                              {DescriptorKind::kSampledImage, "sampled_image"},
                                              {DescriptorKind::kSampler, "sampler"},
                                              {DescriptorKind::kStorageImage, "storage_image"}})
NLOHMANN_JSON_SERIALIZE_ENUM(ImageDimension, {{ImageDimension::kNone, "none"},
                                              {ImageDimension::k1D, "1d"},
                                              {ImageDimension::k2D, "2d"},
                                              {ImageDimension::k3D, "3d"},
                                              {ImageDimension::kCube, "cube"},
                                              {ImageDimension::k2DArray, "2d_array"},
                                              {ImageDimension::kCubeArray, "cube_array"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BlockMember, name, scalar, rows, columns, offset, matrix_stride, row_major, array_length,
                                   array_stride)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Descriptor, name, set, binding, count, kind, dimension, stages, size_bytes, members)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PushConstantRange, stages, offset, size_bytes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(VertexInput, name, location, scalar, components)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FragmentOutput, name, location, scalar, components)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ShaderInterface, vertex_inputs, outputs, descriptors, push_constant_name, push_constants,
                                   push_constant_members, writes_depth, discards)

json interfaceJson(const ShaderInterface& interface) { return json(interface); }

ShaderInterface interfaceFrom(const json& from) { return from.get<ShaderInterface>(); }

std::string interfaceToJson(const ShaderInterface& interface) { return interfaceJson(interface).dump(2); }

Result<ShaderInterface> interfaceFromJson(const std::string& text) {
  try {
    return interfaceFrom(json::parse(text));
  } catch (const std::exception& failure) {
    return Error{ErrorKind::kInput, "package.manifest", std::string("this is no shader interface: ") + failure.what(), {}};
  }
}

}  // namespace reprise
