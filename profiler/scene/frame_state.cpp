#include "profiler/scene/frame_state.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "profiler/scenario/read_models.h"
#include "profiler/scene/track.h"

namespace reprise {
namespace {

glm::vec3 vectorOf(const std::array<float, 3>& values) {
  return {values[0], values[1], values[2]};
}

glm::vec3 perpendicularTo(const glm::vec3& direction, const glm::vec3& wish) {
  const glm::vec3 rest = wish - direction * glm::dot(wish, direction);
  if (glm::length(rest) > 1e-3f) return glm::normalize(rest);
  const glm::vec3 other = std::abs(direction.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(other - direction * glm::dot(other, direction));
}

// Turns per frame accumulate: reduced in double, so that late frames are as exact as early ones.
float turnAt(float start_rad, float step_rad, double steps) {
  return static_cast<float>(std::fmod(start_rad + static_cast<double>(step_rad) * steps, 6.283185307179586));
}

struct View {
  glm::vec3 eye, target;
};

// What tracks are evaluated at.
struct Moment {
  double time_s;
  double steps;  // frames times speed
  std::uint32_t seed;
};

glm::vec3 vectorAt(const Track& track, const Moment& moment) {
  const std::vector<float> values = evaluateTrack(track, moment.time_s, moment.seed);
  REPRISE_CHECK(values.size() == 3, values.size());
  return {values[0], values[1], values[2]};
}

View viewAt(const Camera& camera, const Moment& moment) {
  if (const auto* path = std::get_if<TrackPath>(&camera.path)) {
    return {vectorAt(path->eye, moment), vectorAt(path->target, moment)};
  }
  const OrbitPath& orbit = std::get<OrbitPath>(camera.path);
  const glm::vec3 up = glm::normalize(vectorOf(camera.up)), ahead = perpendicularTo(up, {0, 0, 1});
  const glm::vec3 aside = glm::cross(up, ahead);
  const float angle = turnAt(orbit.start_rad, orbit.radians_per_frame, moment.steps);
  const glm::vec3 target = vectorOf(orbit.target);
  return {target + orbit.radius * (std::cos(angle) * ahead + std::sin(angle) * aside) + orbit.height * up,
          target};
}

glm::mat4 viewMatrix(const View& view, const Camera& camera) {
  const glm::vec3 up = glm::normalize(vectorOf(camera.up));
  glm::vec3 ahead = view.target - view.eye;
  ahead = glm::length(ahead) > 1e-6f ? glm::normalize(ahead) : perpendicularTo(up, {0, 0, -1});
  // A camera that looks along `up` has no right side of its own: take any.
  const bool steep = std::abs(glm::dot(ahead, up)) > 0.9999f;
  return glm::lookAtRH(view.eye, view.eye + ahead, steep ? perpendicularTo(ahead, {0, 0, -1}) : up);
}

glm::mat4 projectionMatrix(const Camera& camera, float aspect) {
  const float first = camera.reverse_z ? camera.far_plane : camera.near_plane;
  const float last = camera.reverse_z ? camera.near_plane : camera.far_plane;
  glm::mat4 projection;
  if (camera.orthographic) {
    const float half_height = camera.ortho_height / 2, half_width = half_height * aspect;
    projection = glm::orthoRH_ZO(-half_width, half_width, -half_height, half_height, first, last);
  } else {
    projection = glm::perspectiveRH_ZO(glm::radians(camera.fov_y_deg), aspect, first, last);
  }
  for (int column = 0; column < 4; ++column) projection[column][1] = -projection[column][1];
  return projection;
}

glm::mat4 modelMatrix(const Motion& motion, const Moment& moment) {
  const glm::vec3 turns = glm::radians(vectorAt(motion.rotate_deg, moment));
  glm::mat4 model = glm::translate(glm::mat4(1), vectorAt(motion.translate, moment));
  model = glm::rotate(model, turns.z, glm::vec3(0, 0, 1));
  model = glm::rotate(model, turns.y, glm::vec3(0, 1, 0));
  model = glm::rotate(model, turns.x, glm::vec3(1, 0, 0));
  model = glm::rotate(model, turnAt(0, motion.spin_rad_per_frame, moment.steps),
                      glm::normalize(vectorOf(motion.spin_axis)));
  return glm::scale(model, vectorAt(motion.scale, moment));
}

}  // namespace

FrameState evaluateFrame(const Scenario& scenario, const SessionSpec& session, int frame) {
  const double steps = static_cast<double>(frame) * session.speed;
  const Moment moment = {steps * scenario.frame_time_s, steps, scenario.seed};
  FrameState state;
  state.frame = frame;
  state.time_s = static_cast<float>(moment.time_s);
  state.width = scenario.width;
  state.height = scenario.height;
  const View view = viewAt(session.camera, moment);
  state.camera_position = view.eye;
  state.view = viewMatrix(view, session.camera);
  state.projection = projectionMatrix(
      session.camera, static_cast<float>(scenario.width) / static_cast<float>(scenario.height));
  for (const ModelSpec& model : scenario.models) {
    const auto override_motion = session.motions.find(model.name);
    state.placements.push_back(modelMatrix(override_motion == session.motions.end() ? model.motion : override_motion->second, moment));
    state.poses.push_back(poseAt(*model.scene, animationOf(model), model.phase_s + static_cast<double>(model.speed) * moment.time_s));
  }
  for (const Object& object : scenario.objects) {
    if (object.part) {
      const GltfInstance& instance = scenario.models[object.part->model].scene->instances[object.part->instance];
      const glm::mat4& placement = state.placements[object.part->model];
      state.models.push_back(instance.skin >= 0 ? placement : placement * state.poses[object.part->model].nodes[static_cast<std::size_t>(instance.node)]);
      continue;
    }
    const auto override_motion = session.motions.find(object.name);
    state.models.push_back(modelMatrix(
        override_motion == session.motions.end() ? object.motion : override_motion->second, moment));
  }
  return state;
}

}  // namespace reprise
