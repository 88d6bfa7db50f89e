#include "profiler/scenario/read_camera.h"

#include <cmath>
#include <limits>

#include "profiler/scenario/read_motion.h"
#include "profiler/scenario/read_recording.h"

namespace reprise {
namespace {

OrbitPath readOrbit(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  OrbitPath orbit;
  TableReader reader(node, "'orbit' of " + what, diagnostics);
  reader.readNumbers("target", orbit.target);
  reader.readNumber("radius", orbit.radius, kPositive);
  reader.readNumber("height", orbit.height);
  reader.readNumber("start_rad", orbit.start_rad);
  reader.readNumber("radians_per_frame", orbit.radians_per_frame);
  reader.finish();
  return orbit;
}

TrackPath readEyeAndTarget(TableReader& reader) {
  TrackPath path{FixedTrack{{0, 0, 4}}, FixedTrack{{0, 0, 0}}};
  if (!reader.has("eye")) {
    reader.find("eye");
    if (reader.table().kind == NodeKind::kTable) {
      reader.diagnostics().add("missing_key", reader.what() + " needs 'orbit', or 'eye' and 'target', or 'recorded', or 'gltf'",
                               reader.table().place);
    }
  }
  readTrackAt(reader, "eye", path.eye, Need::kOptional);
  readTrackAt(reader, "target", path.target, Need::kOptional);
  return path;
}

// `gltf = "man"`, or a table with the model and which of its cameras.
ModelCameraPath readModelCamera(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  ModelCameraPath path;
  path.place = node.place;
  if (node.kind == NodeKind::kText) {
    path.model = node.text;
    return path;
  }
  TableReader reader(node, "'gltf' of " + what, diagnostics);
  reader.readText("model", path.model, Need::kRequired);
  if (const TomlNode* camera = reader.find("camera")) {
    if (camera->kind == NodeKind::kText) {
      path.camera = camera->text;
    } else {
      int index = 0;
      reader.readInteger("camera", index, {0, kMaxEntries});
      path.camera = index;
    }
  }
  reader.finish();
  return path;
}

CameraPath readCameraPath(TableReader& reader, const std::filesystem::path& directory) {
  std::string first;
  for (const char* key : {"orbit", "recorded", "gltf", "eye", "target"}) {
    if (!reader.has(key)) continue;
    const bool belongs = first.empty() || (first == "eye" && std::string(key) == "target");
    if (first.empty()) first = key;
    if (belongs) continue;
    reader.diagnostics().add("value",
                             reader.what() + " has '" + first + "' and '" + key +
                                 "', expected either 'orbit', or 'eye' and 'target', or 'recorded', or 'gltf'",
                             reader.find(key)->place);
  }
  const TomlNode* recorded = reader.find("recorded");
  const TomlNode* model = reader.find("gltf");
  if (const TomlNode* orbit = reader.find("orbit")) return readOrbit(*orbit, reader.what(), reader.diagnostics());
  if (recorded) return readRecording(*recorded, "'recorded' of " + reader.what(), directory, reader.diagnostics());
  if (model) return readModelCamera(*model, reader.what(), reader.diagnostics());
  return readEyeAndTarget(reader);
}

// Only where lines meet in the eye does a far plane at infinity have a limit.
void readFar(TableReader& reader, Camera& camera) {
  const TomlNode* node = reader.find("far");
  const bool infinite = node && node->kind == NodeKind::kFloat && std::isinf(node->real) && node->real > 0;
  if (!infinite) {
    reader.readNumber("far", camera.far_plane, camera.orthographic ? kAnyNumber : kPositive);
  } else if (camera.orthographic) {
    reader.diagnostics().add("value", "'far' of " + reader.what() + " is inf, which an orthographic camera cannot have; expected a number", node->place);
  } else {
    camera.far_plane = std::numeric_limits<float>::infinity();
  }
}

void readLens(TableReader& reader, Camera& camera) {
  reader.readBoolean("orthographic", camera.orthographic);
  if (camera.orthographic) {
    reader.readNumber("ortho_height", camera.ortho_height, kPositive);
  } else {
    reader.readNumber("fov_y_deg", camera.fov_y_deg, {0, 170, true});
  }
  reader.readNumber("near", camera.near_plane, camera.orthographic ? kAnyNumber : kPositive);
  readFar(reader, camera);
  if (camera.far_plane <= camera.near_plane) {
    reader.diagnostics().add("value",
                             "'far' of " + reader.what() + " does not lie behind 'near': " + std::to_string(camera.far_plane) +
                                 " and " + std::to_string(camera.near_plane),
                             reader.table().place);
  }
}

Handheld readHandheld(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  Handheld handheld;
  TableReader reader(node, "'handheld' of " + what, diagnostics);
  reader.readNumber("move", handheld.move, kNotNegative);
  reader.readNumber("turn_deg", handheld.turn_deg, {0, 180});
  reader.readNumber("frequency_hz", handheld.frequency_hz, {0, 1000, true});
  reader.readUnsigned("seed", handheld.seed);
  reader.finish();
  return handheld;
}

std::vector<CameraCut> readCuts(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  std::vector<CameraCut> cuts;
  if (node.kind != NodeKind::kArray || node.elements.size() > kMaxEntries) {
    diagnostics.add("type",
                    "'cuts' of " + what + " is " + describeNode(node) + ", expected an array of up to " + std::to_string(kMaxEntries) +
                        " tables { at_s = seconds, turn_deg = ..., move = [x, y, z] }",
                    node.place);
    return cuts;
  }
  for (const TomlNode& element : node.elements) {
    CameraCut cut;
    TableReader reader(element, "cut " + std::to_string(cuts.size() + 1) + " of " + what, diagnostics);
    reader.find("at_s", Need::kRequired);
    reader.readNumber("at_s", cut.at_s, kNotNegative);
    reader.readNumber("turn_deg", cut.turn_deg);
    reader.readNumbers("move", cut.move);
    reader.finish();
    if (!cuts.empty() && cut.at_s <= cuts.back().at_s)
      diagnostics.add("value", "'at_s' of " + reader.what() + " is not after that of the cut before it", element.place);
    cuts.push_back(cut);
  }
  return cuts;
}

}  // namespace

Camera readCamera(const TomlNode& node, const std::string& what, const std::filesystem::path& directory, Diagnostics& diagnostics) {
  Camera camera;
  TableReader reader(node, what, diagnostics);
  camera.path = readCameraPath(reader, directory);
  readDirection(reader, "up", camera.up);
  // The lens of a model's camera is the file's: it is not known yet.
  if (!std::holds_alternative<ModelCameraPath>(camera.path)) readLens(reader, camera);
  reader.readBoolean("reverse_z", camera.reverse_z);
  if (const TomlNode* handheld = reader.find("handheld")) camera.handheld = readHandheld(*handheld, what, diagnostics);
  if (const TomlNode* cuts = reader.find("cuts")) camera.cuts = readCuts(*cuts, what, diagnostics);
  reader.finish();
  return camera;
}

}  // namespace reprise
