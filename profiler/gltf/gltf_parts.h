// The parts of a glTF document, read one by one from tinygltf's model into plain values.
#pragma once

#include <string>
#include <vector>

#include "profiler/gltf/gltf_scene.h"
#include "runtime/base/result.h"

namespace tinygltf {
class Model;
}

namespace reprise {

// code without its "gltf."; where: a JSON path.
Error gltfError(const std::string& code, const std::string& where, const std::string& message);

// "where[index]".
std::string elementPath(const std::string& where, std::size_t index);

// Errors: gltf.index unless 0 <= index < size.
Result<void> expectIndex(int index, std::size_t size, const std::string& where);

// Errors: gltf.accessor unless the bytes lie in the view and the view in its buffer; gltf.index.
struct ByteRange {
  const unsigned char* data = nullptr;
  std::size_t size = 0, stride = 0;
};
Result<ByteRange> viewBytes(const tinygltf::Model& model, int view, const std::string& where);

// All numbers of an accessor of `components` (0: any) components, integers turned to floats, normalized ones to [0, 1] or [-1, 1];
// sparse ones filled in. Errors: gltf.index, gltf.accessor, gltf.value (not finite), gltf.limit.
struct AccessorFloats {
  std::vector<float> values;
  std::size_t components = 1;
  std::size_t count() const { return values.size() / components; }
};
Result<AccessorFloats> readAccessor(const tinygltf::Model& model, int accessor, std::size_t components, const std::string& where);
Result<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model, int accessor, const std::string& where);

Result<void> readMaterials(const tinygltf::Model& model, GltfScene& scene);
Result<void> readMeshes(const tinygltf::Model& model, GltfScene& scene);   // after the materials
Result<void> readNodes(const tinygltf::Model& model, GltfScene& scene);    // after the meshes
Result<void> readAnimations(const tinygltf::Model& model, GltfScene& scene);  // after the nodes

}  // namespace reprise
