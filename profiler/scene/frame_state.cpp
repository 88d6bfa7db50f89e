#include "profiler/scene/frame_state.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "profiler/scenario/read_models.h"
#include "profiler/scene/camera_pose.h"
#include "profiler/scene/moment.h"

namespace reprise {
namespace {

glm::mat4 projectionMatrix(const Camera& camera, float fov_y_deg, float aspect) {
  const float first = camera.reverse_z ? camera.far_plane : camera.near_plane;
  const float last = camera.reverse_z ? camera.near_plane : camera.far_plane;
  glm::mat4 projection;
  if (camera.orthographic) {
    const float half_height = camera.ortho_height / 2, half_width = half_height * aspect;
    projection = glm::orthoRH_ZO(-half_width, half_width, -half_height, half_height, first, last);
  } else {
    projection = glm::perspectiveRH_ZO(glm::radians(fov_y_deg), aspect, first, last);
    if (std::isinf(camera.far_plane)) {  // the limit of the same two elements
      projection[2][2] = camera.reverse_z ? 0.0f : -1.0f;
      projection[3][2] = camera.reverse_z ? camera.near_plane : -camera.near_plane;
    }
  }
  for (int column = 0; column < 4; ++column) projection[column][1] = -projection[column][1];
  return projection;
}

// right: how far along the camera's right axis, in units of the world.
void moveToEye(float right, FrameState& state) {
  const glm::vec3 axis = {state.view[0][0], state.view[1][0], state.view[2][0]};
  state.camera_position += right * axis;
  state.view = glm::translate(glm::mat4(1), {-right, 0, 0}) * state.view;
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

FrameState evaluateFrame(const Scenario& scenario, const SessionSpec& session, int image) {
  const int frame = scenario.stereo ? image / 2 : image;
  const double steps = static_cast<double>(frame) * session.speed;
  const Moment moment = {steps * scenario.frame_time_s, steps, scenario.seed};
  FrameState state;
  state.frame = frame;
  state.time_s = static_cast<float>(moment.time_s);
  state.width = scenario.width;
  state.height = scenario.height;
  for (const ModelSpec& model : scenario.models) {
    const auto override_motion = session.motions.find(model.name);
    state.placements.push_back(modelMatrix(override_motion == session.motions.end() ? model.motion : override_motion->second, moment));
    state.poses.push_back(poseAt(*model.scene, animationOf(model), model.phase_s + static_cast<double>(model.speed) * moment.time_s));
  }
  const CameraPose camera = cameraPoseAt(session.camera, moment, state);
  state.camera_position = camera.eye;
  state.view = camera.view;
  if (scenario.stereo) moveToEye(image % 2 == 0 ? -scenario.stereo->eye_distance / 2 : scenario.stereo->eye_distance / 2, state);
  state.projection = projectionMatrix(session.camera, camera.fov_y_deg,
                                      static_cast<float>(scenario.width) / static_cast<float>(scenario.height));
  for (const PassSpec& pass : scenario.passes) {
    if (pass.kind != ScenePassKind::kShadow) {
      state.pass_views.push_back({state.view, state.projection, state.camera_position});
      continue;
    }
    const CameraPose light = cameraPoseAt(pass.light, moment, state);
    state.pass_views.push_back({light.view, projectionMatrix(pass.light, light.fov_y_deg, 1), light.eye});
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

FrameState seenByPass(const Scenario& scenario, const FrameState& state, std::size_t pass) {
  FrameState seen = state;
  const PassView& view = state.pass_views.at(pass);
  seen.view = view.view;
  seen.projection = view.projection;
  seen.camera_position = view.position;
  if (scenario.passes[pass].kind == ScenePassKind::kShadow) seen.width = seen.height = scenario.passes[pass].size;
  return seen;
}

}  // namespace reprise
