// Camera paths that come from elsewhere, and what happens to any path: shake and cuts. Positions are in world units, angles in
// degrees, times in seconds from the start of the session.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

// One row of a recording. rotation: a unit quaternion x, y, z, w from camera to world; the camera looks along its -z, its +y is up
// and its +x right (glTF's convention).
struct CameraKey {
  float at_s = 0;
  std::array<float, 3> position = {0, 0, 0};
  std::array<float, 4> rotation = {0, 0, 0, 1};
  float fov_y_deg = 0;  // 0: the camera's own, then in all rows
  bool operator==(const CameraKey&) const = default;
};

// What an application saw: positions and angles of view are linear between rows, rotations turn evenly (slerp, the short way); the
// first and the last row hold outside. Times rise strictly, the first is 0.
struct RecordedPath {
  std::vector<CameraKey> keys;
  bool operator==(const RecordedPath&) const = default;
};

// A camera of a [[model]]: it moves with its node, and so with the model's animation and motion. The lens is the file's.
struct ModelCameraPath {
  std::string model;
  std::variant<int, std::string> camera = 0;       // index in the file, or the name of the camera or its node
  std::size_t model_index = 0, node_index = 0;     // found by placeModelCameras (model_cameras.h)
  Place place;                                     // not compared
  bool operator==(const ModelCameraPath& other) const {
    return model == other.model && camera == other.camera && model_index == other.model_index && node_index == other.node_index;
  }
};

// Seeded shake, added in the camera's own axes; the formula is in profiler/scene/handheld.h.
struct Handheld {
  float move = 0;          // at most, along each axis
  float turn_deg = 0;      // at most, about each axis
  float frequency_hz = 2;
  std::uint32_t seed = 1;  // mixed with the scenario's
  bool operator==(const Handheld&) const = default;
};

// From at_s on the path is turned about `up` through what the camera looks at (recordings and models: through the camera), then
// moved. Cuts add up in their order.
struct CameraCut {
  float at_s = 0;
  float turn_deg = 0;
  std::array<float, 3> move = {0, 0, 0};
  bool operator==(const CameraCut&) const = default;
};

}  // namespace reprise
