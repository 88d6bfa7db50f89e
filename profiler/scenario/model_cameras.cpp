#include "profiler/scenario/model_cameras.h"

#include <algorithm>
#include <numbers>

#include "profiler/scenario/near_names.h"

namespace reprise {
namespace {

Error refusal(const ModelCameraPath& path, const std::string& message) {
  return {ErrorKind::kInput, "scenario.value", "'gltf' of a camera: " + message, path.place};
}

Result<std::size_t> modelNamed(const ModelCameraPath& path, const Scenario& scenario) {
  std::vector<std::string> names;
  for (const ModelSpec& model : scenario.models) names.push_back(model.name);
  const auto found = std::find(names.begin(), names.end(), path.model);
  if (found == names.end()) return refusal(path, "there is no [[model]] '" + path.model + "'" + suggestNames(path.model, names));
  return static_cast<std::size_t>(found - names.begin());
}

// The first node of the scene that holds the camera; by name, the camera's or the node's own.
Result<std::size_t> nodeOf(const ModelCameraPath& path, const Scenario& scenario) {
  const GltfScene& scene = *scenario.models[path.model_index].scene;
  std::vector<std::string> names;
  for (const int n : scene.order) {
    const GltfNode& node = scene.nodes[static_cast<std::size_t>(n)];
    if (node.camera < 0) continue;
    const std::string& camera = scene.cameras[static_cast<std::size_t>(node.camera)].name;
    const auto* index = std::get_if<int>(&path.camera);
    const auto* name = std::get_if<std::string>(&path.camera);
    if ((index && *index == node.camera) || (name && (*name == camera || *name == node.name))) return static_cast<std::size_t>(n);
    names.insert(names.end(), {camera, node.name});
  }
  std::erase(names, "");
  if (scene.cameras.empty()) return refusal(path, "model '" + path.model + "' has no cameras");
  if (const auto* index = std::get_if<int>(&path.camera))
    return refusal(path, "the scene of model '" + path.model + "' shows no camera " + std::to_string(*index) + "; its file has " + std::to_string(scene.cameras.size()));
  const std::string& name = std::get<std::string>(path.camera);
  return refusal(path, "model '" + path.model + "' has no camera '" + name + "'" + suggestNames(name, names));
}

void takeLens(const GltfCamera& from, Camera& camera) {
  camera.orthographic = from.orthographic;
  if (from.orthographic)
    camera.ortho_height = from.height;
  else
    camera.fov_y_deg = static_cast<float>(from.fov_y_rad * 180 / std::numbers::pi);
  camera.near_plane = from.near_plane;
  camera.far_plane = from.far_plane;
}

}  // namespace

Result<void> placeModelCameras(Scenario& scenario) {
  for (SessionSpec& session : scenario.sessions) {
    auto* path = std::get_if<ModelCameraPath>(&session.camera.path);
    if (!path) continue;
    REPRISE_ASSIGN(path->model_index, modelNamed(*path, scenario));
    REPRISE_ASSIGN(path->node_index, nodeOf(*path, scenario));
    const GltfScene& scene = *scenario.models[path->model_index].scene;
    takeLens(scene.cameras[static_cast<std::size_t>(scene.nodes[path->node_index].camera)], session.camera);
  }
  return {};
}

}  // namespace reprise
