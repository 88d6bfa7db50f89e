#include "profiler/scene/camera_pose.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "profiler/scene/handheld.h"

namespace reprise {
namespace {

// A cut at a frame's time but for its rounding is that frame's.
constexpr double kTimeRounding_s = 1e-6;

glm::vec3 perpendicularTo(const glm::vec3& direction, const glm::vec3& wish) {
  const glm::vec3 rest = wish - direction * glm::dot(wish, direction);
  if (glm::length(rest) > 1e-3f) return glm::normalize(rest);
  const glm::vec3 other = std::abs(direction.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(other - direction * glm::dot(other, direction));
}

// A pose with what it looks at: cuts turn about `target`.
struct Sight {
  CameraPose pose;
  glm::vec3 target{0};
};

glm::mat4 lookAt(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& wished_up) {
  const glm::vec3 up = glm::normalize(wished_up);
  glm::vec3 ahead = target - eye;
  ahead = glm::length(ahead) > 1e-6f ? glm::normalize(ahead) : perpendicularTo(up, {0, 0, -1});
  // A camera that looks along `up` has no right side of its own: take any.
  const bool steep = std::abs(glm::dot(ahead, up)) > 0.9999f;
  return glm::lookAtRH(eye, eye + ahead, steep ? perpendicularTo(ahead, {0, 0, -1}) : up);
}

// The inverse of a camera's place in the world; the columns of `axes` are its right, up and back.
glm::mat4 viewFrom(const glm::mat3& axes, const glm::vec3& eye) {
  const glm::mat3 turned = glm::transpose(axes);
  glm::mat4 view(turned);
  view[3] = glm::vec4(-(turned * eye), 1);
  return view;
}

// Calls of one form for each kind of path.
struct SightAt {
  const Camera& camera;
  const Moment& moment;
  const FrameState& state;

  Sight towards(const glm::vec3& eye, const glm::vec3& target) const {
    return {{eye, lookAt(eye, target, vectorOf(camera.up)), camera.fov_y_deg}, target};
  }

  Sight operator()(const TrackPath& path) const { return towards(vectorAt(path.eye, moment), vectorAt(path.target, moment)); }

  Sight operator()(const OrbitPath& orbit) const {
    const glm::vec3 up = glm::normalize(vectorOf(camera.up)), ahead = perpendicularTo(up, {0, 0, 1});
    const glm::vec3 aside = glm::cross(up, ahead);
    const float angle = turnAt(orbit.start_rad, orbit.radians_per_frame, moment.steps);
    const glm::vec3 target = vectorOf(orbit.target);
    return towards(target + orbit.radius * (std::cos(angle) * ahead + std::sin(angle) * aside) + orbit.height * up, target);
  }

  Sight operator()(const RecordedPath& path) const {
    const auto after = std::upper_bound(path.keys.begin(), path.keys.end(), moment.time_s, [](double time_s, const CameraKey& key) { return time_s < key.at_s; });
    const CameraKey& last = after == path.keys.end() ? path.keys.back() : *after;
    const CameraKey& first = after == path.keys.begin() ? path.keys.front() : *(after - 1);
    const double span_s = static_cast<double>(last.at_s) - first.at_s;
    const auto part = static_cast<float>(span_s > 0 ? std::clamp((moment.time_s - first.at_s) / span_s, 0.0, 1.0) : 0);
    const auto turn = [](const CameraKey& key) { return glm::quat(key.rotation[3], key.rotation[0], key.rotation[1], key.rotation[2]); };
    const glm::mat3 axes = glm::mat3_cast(glm::normalize(glm::slerp(turn(first), turn(last), part)));
    const glm::vec3 eye = glm::mix(vectorOf(first.position), vectorOf(last.position), part);
    const float fov_y_deg = first.fov_y_deg > 0 ? glm::mix(first.fov_y_deg, last.fov_y_deg, part) : camera.fov_y_deg;
    return {{eye, viewFrom(axes, eye), fov_y_deg}, eye};
  }

  // Nodes may be scaled; cameras are not.
  Sight operator()(const ModelCameraPath& path) const {
    const glm::mat4 place = state.placements[path.model_index] * state.poses[path.model_index].nodes[path.node_index];
    const auto directionOr = [](const glm::vec3& vector, const glm::vec3& otherwise) { return glm::length(vector) > 1e-20f ? glm::normalize(vector) : otherwise; };
    const glm::vec3 back = directionOr(glm::vec3(place[2]), {0, 0, 1});
    const glm::vec3 up = perpendicularTo(back, directionOr(glm::vec3(place[1]), {0, 1, 0}));
    const glm::vec3 eye(place[3]);
    return {{eye, viewFrom(glm::mat3(glm::cross(up, back), up, back), eye), camera.fov_y_deg}, eye};
  }
};

glm::mat3 axesOf(const CameraPose& pose) { return glm::transpose(glm::mat3(pose.view)); }

void cut(const CameraCut& jump, const glm::vec3& up, Sight& sight) {
  const glm::mat3 turn(glm::rotate(glm::mat4(1), glm::radians(jump.turn_deg), glm::normalize(up)));
  sight.pose.eye = sight.target + turn * (sight.pose.eye - sight.target) + vectorOf(jump.move);
  sight.target += vectorOf(jump.move);
  sight.pose.view = viewFrom(turn * axesOf(sight.pose), sight.pose.eye);
}

void shake(const Shake& by, CameraPose& pose) {
  const glm::mat3 axes = axesOf(pose);
  glm::mat4 turn = glm::rotate(glm::mat4(1), by.turn_rad.y, glm::vec3(0, 1, 0));
  turn = glm::rotate(turn, by.turn_rad.x, glm::vec3(1, 0, 0));
  turn = glm::rotate(turn, by.turn_rad.z, glm::vec3(0, 0, 1));
  pose.eye += axes * by.move;
  pose.view = viewFrom(axes * glm::mat3(turn), pose.eye);
}

}  // namespace

CameraPose cameraPoseAt(const Camera& camera, const Moment& moment, const FrameState& state) {
  Sight sight = std::visit(SightAt{camera, moment, state}, camera.path);
  for (const CameraCut& jump : camera.cuts)
    if (moment.time_s + kTimeRounding_s >= jump.at_s) cut(jump, vectorOf(camera.up), sight);
  if (camera.handheld) shake(shakeAt(*camera.handheld, moment), sight.pose);
  return sight.pose;
}

}  // namespace reprise
