#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

#include "profiler/gltf/gltf_parts.h"
#include "profiler/gltf/read_gltf.h"

namespace reprise {
namespace {

Result<std::vector<float>> finiteNumbers(const std::vector<double>& from, std::size_t size, const std::string& where) {
  std::vector<float> values;
  for (const double value : from) {
    values.push_back(static_cast<float>(value));
    if (!std::isfinite(values.back())) return gltfError("value", where, "a number is not finite");
  }
  if (size != 0 && values.size() != size) return gltfError("value", where, "it has " + std::to_string(values.size()) + " numbers, expected " + std::to_string(size));
  return values;
}

Result<void> readTransform(const tinygltf::Node& from, const std::string& where, GltfNode& node) {
  if (!from.matrix.empty()) {
    REPRISE_ASSIGN(const auto values, finiteNumbers(from.matrix, 16, where + ".matrix"));
    node.matrix = glm::make_mat4(values.data());
    node.has_matrix = true;
  }
  if (!from.translation.empty()) {
    REPRISE_ASSIGN(const auto values, finiteNumbers(from.translation, 3, where + ".translation"));
    node.translation = glm::make_vec3(values.data());
  }
  if (!from.rotation.empty()) {
    REPRISE_ASSIGN(const auto values, finiteNumbers(from.rotation, 4, where + ".rotation"));
    const glm::quat rotation(values[3], values[0], values[1], values[2]);
    if (glm::length(rotation) < 1e-6f) return gltfError("value", where + ".rotation", "the quaternion has no length");
    node.rotation = glm::normalize(rotation);
  }
  if (!from.scale.empty()) {
    REPRISE_ASSIGN(const auto values, finiteNumbers(from.scale, 3, where + ".scale"));
    node.scale = glm::make_vec3(values.data());
  }
  return {};
}

Result<int> lightOf(const tinygltf::Node& from, std::size_t lights, const std::string& where) {
  const auto extension = from.extensions.find("KHR_lights_punctual");
  if (extension == from.extensions.end() || !extension->second.Has("light")) return -1;
  const tinygltf::Value& value = extension->second.Get("light");
  const int light = value.IsNumber() ? value.GetNumberAsInt() : -1;
  REPRISE_TRY(expectIndex(light, lights, where + ".extensions.KHR_lights_punctual.light"));
  return light;
}

Result<GltfNode> readNode(const tinygltf::Model& model, std::size_t index) {
  const tinygltf::Node& from = model.nodes[index];
  const std::string where = elementPath("nodes", index);
  GltfNode node;
  node.name = from.name;
  REPRISE_TRY(readTransform(from, where, node));
  if (from.mesh >= 0) REPRISE_TRY(expectIndex(from.mesh, model.meshes.size(), where + ".mesh"));
  if (from.skin >= 0) REPRISE_TRY(expectIndex(from.skin, model.skins.size(), where + ".skin"));
  if (from.camera >= 0) REPRISE_TRY(expectIndex(from.camera, model.cameras.size(), where + ".camera"));
  node.mesh = from.mesh;
  node.skin = from.skin;
  node.camera = from.camera;
  REPRISE_ASSIGN(node.light, lightOf(from, model.lights.size(), where));
  REPRISE_ASSIGN(node.weights, finiteNumbers(from.weights, 0, where + ".weights"));
  return node;
}

Result<void> linkParents(const tinygltf::Model& model, GltfScene& scene) {
  for (std::size_t parent = 0; parent < model.nodes.size(); ++parent)
    for (std::size_t i = 0; i < model.nodes[parent].children.size(); ++i) {
      const std::string where = elementPath(elementPath("nodes", parent) + ".children", i);
      const int child = model.nodes[parent].children[i];
      REPRISE_TRY(expectIndex(child, scene.nodes.size(), where));
      GltfNode& node = scene.nodes[static_cast<std::size_t>(child)];
      if (node.parent >= 0) return gltfError("nodes", where, "nodes[" + std::to_string(child) + "] is already a child of nodes[" + std::to_string(node.parent) + "]");
      node.parent = static_cast<int>(parent);
    }
  return {};
}

// Parents before children, from the roots of the scene on. What no root reaches is not drawn; a node that is its own ancestor is reached by none.
Result<void> orderNodes(const tinygltf::Model& model, GltfScene& scene) {
  std::vector<int> roots;
  const int shown = model.defaultScene >= 0 ? model.defaultScene : 0;
  if (model.defaultScene >= 0) REPRISE_TRY(expectIndex(model.defaultScene, model.scenes.size(), "scene"));
  const std::string where = elementPath("scenes", static_cast<std::size_t>(shown)) + ".nodes";
  if (!model.scenes.empty()) {
    roots = model.scenes[static_cast<std::size_t>(shown)].nodes;
  } else {
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
      if (scene.nodes[i].parent < 0) roots.push_back(static_cast<int>(i));
  }
  std::vector<char> seen(scene.nodes.size(), 0);
  const auto visit = [&](int node) -> Result<void> {
    if (seen[static_cast<std::size_t>(node)]++) return gltfError("nodes", elementPath("nodes", static_cast<std::size_t>(node)), "it is reached twice");
    scene.order.push_back(node);
    return {};
  };
  for (std::size_t i = 0; i < roots.size(); ++i) {
    REPRISE_TRY(expectIndex(roots[i], scene.nodes.size(), elementPath(where, i)));
    if (scene.nodes[static_cast<std::size_t>(roots[i])].parent >= 0)
      return gltfError("nodes", elementPath(where, i), "nodes[" + std::to_string(roots[i]) + "] has a parent, so it is no root");
    REPRISE_TRY(visit(roots[i]));
  }
  for (std::size_t at = 0; at < scene.order.size(); ++at)
    for (const int child : model.nodes[static_cast<std::size_t>(scene.order[at])].children) REPRISE_TRY(visit(child));
  return {};
}

// Every parent chain must end: a circle of nodes would hang whoever walks up, reached from the scene or not.
Result<void> expectNoCircles(const GltfScene& scene) {
  std::vector<char> ends(scene.nodes.size(), 0);
  for (std::size_t start = 0; start < scene.nodes.size(); ++start) {
    std::vector<std::size_t> walked;
    int at = static_cast<int>(start);
    while (at >= 0 && !ends[static_cast<std::size_t>(at)]) {
      walked.push_back(static_cast<std::size_t>(at));
      if (walked.size() > scene.nodes.size()) return gltfError("nodes", elementPath("nodes", start), "it is its own ancestor");
      at = scene.nodes[static_cast<std::size_t>(at)].parent;
    }
    for (const std::size_t node : walked) ends[node] = 1;
  }
  return {};
}

Result<void> readSkins(const tinygltf::Model& model, GltfScene& scene) {
  for (std::size_t s = 0; s < model.skins.size(); ++s) {
    const tinygltf::Skin& from = model.skins[s];
    const std::string where = elementPath("skins", s);
    if (from.joints.empty() || from.joints.size() > kMostJoints)
      return gltfError("limit", where + ".joints", "there are " + std::to_string(from.joints.size()) + ", expected 1 to " + std::to_string(kMostJoints));
    GltfSkin skin;
    for (std::size_t j = 0; j < from.joints.size(); ++j) {
      REPRISE_TRY(expectIndex(from.joints[j], scene.nodes.size(), elementPath(where + ".joints", j)));
      skin.joints.push_back(from.joints[j]);
    }
    skin.inverse_bind.assign(skin.joints.size(), glm::mat4(1));
    if (from.inverseBindMatrices >= 0) {
      REPRISE_ASSIGN(const AccessorFloats matrices, readAccessor(model, from.inverseBindMatrices, 16, where + ".inverseBindMatrices"));
      if (matrices.count() < skin.joints.size())
        return gltfError("accessor", where + ".inverseBindMatrices", "it has " + std::to_string(matrices.count()) + " matrices for " + std::to_string(skin.joints.size()) + " joints");
      for (std::size_t j = 0; j < skin.joints.size(); ++j) skin.inverse_bind[j] = glm::make_mat4(&matrices.values[j * 16]);
    }
    scene.skins.push_back(std::move(skin));
  }
  return {};
}

Result<void> readCameras(const tinygltf::Model& model, GltfScene& scene) {
  for (std::size_t c = 0; c < model.cameras.size(); ++c) {
    const tinygltf::Camera& from = model.cameras[c];
    GltfCamera camera;
    camera.name = from.name;
    camera.orthographic = from.type == "orthographic";
    if (camera.orthographic) {
      camera.height = static_cast<float>(2 * from.orthographic.ymag);
      camera.near_plane = static_cast<float>(from.orthographic.znear);
      camera.far_plane = static_cast<float>(from.orthographic.zfar);
    } else {
      camera.fov_y_rad = static_cast<float>(from.perspective.yfov);
      camera.near_plane = static_cast<float>(from.perspective.znear);
      camera.far_plane = from.perspective.zfar > 0 ? static_cast<float>(from.perspective.zfar) : std::numeric_limits<float>::infinity();
    }
    const bool sound = camera.near_plane >= 0 && camera.far_plane > camera.near_plane && (camera.far_plane < 1e30f || (std::isinf(camera.far_plane) && !camera.orthographic)) &&
                       (camera.orthographic ? camera.height > 0 : camera.near_plane > 0 && camera.fov_y_rad > 0 && camera.fov_y_rad < 3.1f);
    if (!sound) return gltfError("value", elementPath("cameras", c), "its angle, size or planes make no sense");
    scene.cameras.push_back(camera);
  }
  return {};
}

Result<void> readLights(const tinygltf::Model& model, GltfScene& scene) {
  for (std::size_t l = 0; l < model.lights.size(); ++l) {
    const tinygltf::Light& from = model.lights[l];
    GltfLight light;
    light.kind = from.type == "directional" ? GltfLightKind::kDirectional : from.type == "spot" ? GltfLightKind::kSpot : GltfLightKind::kPoint;
    for (std::size_t i = 0; i < 3; ++i) light.color[i] = static_cast<float>((from.color.size() == 3 ? from.color[i] : 1) * from.intensity);
    light.range = static_cast<float>(from.range);
    light.inner_cone_rad = static_cast<float>(from.spot.innerConeAngle);
    light.outer_cone_rad = static_cast<float>(from.spot.outerConeAngle);
    if (!std::isfinite(light.color[0] + light.color[1] + light.color[2] + light.range + light.inner_cone_rad + light.outer_cone_rad))
      return gltfError("value", elementPath("extensions.KHR_lights_punctual.lights", l), "a number is not finite");
    scene.lights.push_back(light);
  }
  return {};
}

// Every joint that a vertex names must be one of the skin's.
Result<void> expectJoints(const GltfScene& scene, const GltfInstance& instance) {
  const GltfPrimitive& primitive = primitiveOf(scene, instance);
  const auto joints = static_cast<float>(scene.skins[static_cast<std::size_t>(instance.skin)].joints.size());
  for (const DeformVertex& vertex : primitive.deform)
    for (const float joint : vertex.joints)
      if (joint >= joints)
        return gltfError("index", elementPath(elementPath("meshes", static_cast<std::size_t>(instance.mesh)) + ".primitives", static_cast<std::size_t>(instance.primitive)) + ".attributes.JOINTS_0",
                         "it names joint " + std::to_string(static_cast<int>(joint)) + " of skins[" + std::to_string(instance.skin) + "], which has " + std::to_string(static_cast<int>(joints)));
  return {};
}

Result<void> listInstances(GltfScene& scene) {
  for (const int index : scene.order) {
    const GltfNode& node = scene.nodes[static_cast<std::size_t>(index)];
    if (node.mesh < 0) continue;
    const GltfMesh& mesh = scene.meshes[static_cast<std::size_t>(node.mesh)];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      // A mesh without weights is drawn where its node is, whatever skin that has.
      const std::vector<DeformVertex>& deform = mesh.primitives[p].deform;
      const bool weighted = !deform.empty() && deform[0].weights[0] + deform[0].weights[1] + deform[0].weights[2] + deform[0].weights[3] > 0;
      GltfInstance instance{index, node.mesh, static_cast<int>(p), weighted ? node.skin : -1, false};
      if (mesh.primitives[p].indices.empty()) continue;
      if (scene.instances.size() == kMostGltfInstances)
        return gltfError("limit", elementPath("nodes", static_cast<std::size_t>(index)), "the scene draws more than " + std::to_string(kMostGltfInstances) + " primitives");
      if (instance.skin >= 0) REPRISE_TRY(expectJoints(scene, instance));
      scene.instances.push_back(instance);
    }
  }
  if (scene.instances.empty()) return gltfError("empty", "scene", "it draws no triangles");
  return {};
}

}  // namespace

Result<void> readNodes(const tinygltf::Model& model, GltfScene& scene) {
  if (model.nodes.size() > kMostGltfNodes) return gltfError("limit", "nodes", "there are " + std::to_string(model.nodes.size()));
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    REPRISE_ASSIGN(GltfNode node, readNode(model, i));
    scene.nodes.push_back(std::move(node));
  }
  REPRISE_TRY(linkParents(model, scene));
  REPRISE_TRY(expectNoCircles(scene));
  REPRISE_TRY(orderNodes(model, scene));
  REPRISE_TRY(readSkins(model, scene));
  REPRISE_TRY(readCameras(model, scene));
  REPRISE_TRY(readLights(model, scene));
  return listInstances(scene);
}

}  // namespace reprise
