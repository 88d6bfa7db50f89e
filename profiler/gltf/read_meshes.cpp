#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <set>

#include "profiler/gltf/gltf_parts.h"
#include "profiler/gltf/read_gltf.h"
#include "profiler/gltf/tangents.h"

namespace reprise {
namespace {

class PrimitiveReader {
 public:
  PrimitiveReader(const tinygltf::Model& model, const tinygltf::Primitive& from, std::string where, GltfScene& scene)
      : model_(model), from_(from), where_(std::move(where)), scene_(scene) {}

  Result<GltfPrimitive> read() {
    REPRISE_TRY(readVertices());
    REPRISE_TRY(readTriangles());
    REPRISE_TRY(readSkinning());
    REPRISE_TRY(readTargets());
    if (from_.attributes.count("NORMAL") == 0) addFlatNormals();
    REPRISE_TRY(readTangents());
    return std::move(result_);
  }

 private:
  std::string attribute(const std::string& name) const { return where_ + ".attributes." + name; }

  // The floats of an attribute that may be absent: then none.
  Result<AccessorFloats> floats(const std::map<std::string, int>& attributes, const std::string& name, std::size_t components, const std::string& where) const {
    const auto found = attributes.find(name);
    if (found == attributes.end()) return AccessorFloats{};
    REPRISE_ASSIGN(AccessorFloats read, readAccessor(model_, found->second, components, where + name));
    if (!result_.vertices.empty() && read.count() != result_.vertices.size())
      return gltfError("accessor", where + name, "it has " + std::to_string(read.count()) + " elements, the positions have " +
                                                     std::to_string(result_.vertices.size()));
    return read;
  }

  Result<void> readVertices() {
    if (from_.attributes.count("POSITION") == 0) return gltfError("accessor", attribute("POSITION"), "it is absent");
    const std::string place = where_ + ".attributes.";
    REPRISE_ASSIGN(const AccessorFloats positions, floats(from_.attributes, "POSITION", 3, place));
    if (positions.count() > kMostGltfVertices) return gltfError("limit", attribute("POSITION"), "too many vertices: " + std::to_string(positions.count()));
    result_.vertices.resize(positions.count());
    REPRISE_ASSIGN(const AccessorFloats normals, floats(from_.attributes, "NORMAL", 3, place));
    REPRISE_ASSIGN(const AccessorFloats coordinates, floats(from_.attributes, "TEXCOORD_0", 2, place));
    REPRISE_ASSIGN(const AccessorFloats colors, floats(from_.attributes, "COLOR_0", 0, place));
    for (std::size_t i = 0; i < result_.vertices.size(); ++i) {
      Vertex& vertex = result_.vertices[i];
      vertex = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0, 1}, {0, 0}, {1, 1, 1, 1}};
      std::copy_n(&positions.values[i * 3], 3, vertex.position);
      if (!normals.values.empty()) std::copy_n(&normals.values[i * 3], 3, vertex.normal);
      if (!coordinates.values.empty()) std::copy_n(&coordinates.values[i * 2], 2, vertex.uv);
      if (!colors.values.empty()) std::copy_n(&colors.values[i * colors.components], std::min<std::size_t>(colors.components, 4), vertex.color);
    }
    return {};
  }

  Result<void> readTriangles() {
    std::vector<std::uint32_t> listed(result_.vertices.size());
    std::iota(listed.begin(), listed.end(), 0u);
    if (from_.indices >= 0) {
      REPRISE_ASSIGN(listed, readIndices(model_, from_.indices, where_ + ".indices"));
      for (const std::uint32_t index : listed)
        if (index >= result_.vertices.size())
          return gltfError("index", where_ + ".indices", "it names vertex " + std::to_string(index) + " of " + std::to_string(result_.vertices.size()));
    }
    if (listed.size() > 3 * kMostGltfVertices) return gltfError("limit", where_ + ".indices", "too many indices: " + std::to_string(listed.size()));
    if (from_.mode == TINYGLTF_MODE_TRIANGLES || from_.mode == -1) {
      listed.resize(listed.size() / 3 * 3);
      result_.indices = std::move(listed);
      return {};
    }
    const bool fan = from_.mode == TINYGLTF_MODE_TRIANGLE_FAN;
    for (std::size_t i = 0; i + 2 < listed.size(); ++i) {
      const std::size_t odd = i % 2;
      const std::uint32_t strip[3] = {listed[i], listed[i + 1 + odd], listed[i + 2 - odd]};
      const std::uint32_t around[3] = {listed[i + 1], listed[i + 2], listed[0]};
      result_.indices.insert(result_.indices.end(), fan ? around : strip, (fan ? around : strip) + 3);
    }
    return {};
  }

  Result<void> readSkinning() {
    const std::string place = where_ + ".attributes.";
    if (from_.attributes.count("JOINTS_0") == 0) return {};
    REPRISE_ASSIGN(const AccessorFloats joints, floats(from_.attributes, "JOINTS_0", 4, place));
    REPRISE_ASSIGN(const AccessorFloats weights, floats(from_.attributes, "WEIGHTS_0", 4, place));
    if (weights.values.empty()) return gltfError("accessor", attribute("WEIGHTS_0"), "it is absent, but JOINTS_0 is there");
    if (from_.attributes.count("JOINTS_1") != 0) scene_.warnings.push_back(attribute("JOINTS_1") + ": more than four joints a vertex are not read");
    result_.deform.resize(result_.vertices.size());
    for (std::size_t i = 0; i < result_.deform.size(); ++i) {
      DeformVertex& deform = result_.deform[i];
      float sum = 0;
      for (std::size_t j = 0; j < 4; ++j) sum += weights.values[i * 4 + j];
      for (std::size_t j = 0; j < 4; ++j) {
        const float joint = joints.values[i * 4 + j];
        if (joint < 0 || joint >= kMostJoints) return gltfError("limit", attribute("JOINTS_0"), "a joint's number is not below " + std::to_string(kMostJoints));
        deform.joints[j] = joint;
        deform.weights[j] = sum > 1e-6f ? weights.values[i * 4 + j] / sum : (j == 0 ? 1.0f : 0.0f);
      }
    }
    return {};
  }

  Result<void> readTargets() {
    if (from_.targets.empty()) return {};
    if (from_.targets.size() > 4096) return gltfError("limit", where_ + ".targets", "there are " + std::to_string(from_.targets.size()));
    // The four that move the vertices the most; decided from one pass over the positions, so that only they are held.
    std::vector<std::pair<double, std::size_t>> moved;
    for (std::size_t t = 0; t < from_.targets.size(); ++t) {
      REPRISE_ASSIGN(const AccessorFloats positions, floats(from_.targets[t], "POSITION", 3, elementPath(where_ + ".targets", t) + "."));
      double sum = 0;
      for (const float value : positions.values) sum += std::abs(value);
      moved.emplace_back(-sum, t);
    }
    std::sort(moved.begin(), moved.end());
    if (moved.size() > kMorphTargets) {
      scene_.warnings.push_back(where_ + ".targets: of " + std::to_string(moved.size()) + " morph targets the " + std::to_string(kMorphTargets) +
                                " that move the vertices the most are kept");
      moved.resize(kMorphTargets);
    }
    for (const auto& [sum, target] : moved) result_.targets.push_back(target);
    std::sort(result_.targets.begin(), result_.targets.end());
    result_.deform.resize(result_.vertices.size());
    for (std::size_t slot = 0; slot < result_.targets.size(); ++slot) REPRISE_TRY(readTarget(slot));
    return {};
  }

  Result<void> readTarget(std::size_t slot) {
    const auto& target = from_.targets[result_.targets[slot]];
    const std::string place = elementPath(where_ + ".targets", result_.targets[slot]) + ".";
    REPRISE_ASSIGN(const AccessorFloats positions, floats(target, "POSITION", 3, place));
    REPRISE_ASSIGN(const AccessorFloats normals, floats(target, "NORMAL", 3, place));
    for (std::size_t i = 0; i < result_.deform.size(); ++i) {
      if (!positions.values.empty()) std::copy_n(&positions.values[i * 3], 3, result_.deform[i].morph_position[slot]);
      if (!normals.values.empty()) std::copy_n(&normals.values[i * 3], 3, result_.deform[i].morph_normal[slot]);
    }
    return {};
  }

  // Each triangle gets vertices of its own.
  void addFlatNormals() {
    std::vector<Vertex> vertices;
    std::vector<DeformVertex> deform;
    for (std::size_t corner = 0; corner < result_.indices.size(); ++corner) {
      const auto at = [&](std::size_t i) {
        const float* p = result_.vertices[result_.indices[corner / 3 * 3 + i]].position;
        return glm::vec3(p[0], p[1], p[2]);
      };
      const glm::vec3 across = glm::cross(at(1) - at(0), at(2) - at(0));
      const float length = glm::length(across);
      const glm::vec3 normal = length > 0 ? across / length : glm::vec3(0, 1, 0);
      vertices.push_back(result_.vertices[result_.indices[corner]]);
      for (int i = 0; i < 3; ++i) vertices.back().normal[i] = normal[i];
      if (!result_.deform.empty()) deform.push_back(result_.deform[result_.indices[corner]]);
    }
    std::iota(result_.indices.begin(), result_.indices.end(), 0u);
    result_.vertices = std::move(vertices);
    result_.deform = std::move(deform);
  }

  Result<void> readTangents() {
    const bool has_normals = from_.attributes.count("NORMAL") != 0;
    if (has_normals && from_.attributes.count("TANGENT") != 0) {
      REPRISE_ASSIGN(const AccessorFloats tangents, floats(from_.attributes, "TANGENT", 4, where_ + ".attributes."));
      for (std::size_t i = 0; i < result_.vertices.size(); ++i) std::copy_n(&tangents.values[i * 4], 4, result_.vertices[i].tangent);
    } else {
      addTangents(result_.vertices, result_.deform, result_.indices);
    }
    return {};
  }

  const tinygltf::Model& model_;
  const tinygltf::Primitive& from_;
  std::string where_;
  GltfScene& scene_;
  GltfPrimitive result_;
};

}  // namespace

Result<void> readMeshes(const tinygltf::Model& model, GltfScene& scene) {
  std::size_t vertices = 0;
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    GltfMesh mesh;
    mesh.weights.assign(model.meshes[m].weights.begin(), model.meshes[m].weights.end());
    for (std::size_t p = 0; p < model.meshes[m].primitives.size(); ++p) {
      const tinygltf::Primitive& from = model.meshes[m].primitives[p];
      const std::string where = elementPath(elementPath("meshes", m) + ".primitives", p);
      if (from.mode >= 0 && from.mode < TINYGLTF_MODE_TRIANGLES) {
        scene.warnings.push_back(where + ": points and lines are not drawn");
        continue;
      }
      if (from.material >= 0) REPRISE_TRY(expectIndex(from.material, scene.materials.size(), where + ".material"));
      REPRISE_ASSIGN(GltfPrimitive primitive, PrimitiveReader(model, from, where, scene).read());
      primitive.material = from.material;
      vertices += primitive.vertices.size();
      if (vertices > kMostGltfVertices) return gltfError("limit", where, "the meshes have more than " + std::to_string(kMostGltfVertices) + " vertices together");
      mesh.primitives.push_back(std::move(primitive));
    }
    scene.meshes.push_back(std::move(mesh));
  }
  return {};
}

}  // namespace reprise
