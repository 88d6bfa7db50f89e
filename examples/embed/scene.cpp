#include "scene.h"

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace embed {

namespace {

constexpr float kOrbitRadius = 3, kOrbitHeight = 1.5f, kOrbitRadPerFrame = 0.02f;

// In double, so that late frames are as exact as early ones.
float angleAt(float rad_per_frame, int frame) {
  return static_cast<float>(static_cast<double>(rad_per_frame) * frame);
}

glm::vec3 cameraPosition(int frame) {
  const float angle_rad = angleAt(kOrbitRadPerFrame, frame);
  return {kOrbitRadius * std::sin(angle_rad), kOrbitHeight, kOrbitRadius * std::cos(angle_rad)};
}

}  // namespace

Mesh makeSquare(float edge_length) {
  const float half = edge_length / 2;
  const glm::vec3 up{0, 1, 0};
  Mesh mesh;
  mesh.vertices = {
      {{-half, 0, half}, up}, {{half, 0, half}, up}, {{-half, 0, -half}, up}, {{half, 0, -half}, up}};
  mesh.indices = {0, 1, 3, 0, 3, 2};  // counter-clockwise from above
  return mesh;
}

const std::vector<Object>& sceneObjects() {
  static const std::vector<Object> objects = {
      {.id = 1, .edge_length = 6, .centre = {0, -1, 0}},
      {.id = 2,
       .edge_length = 1.5f,
       .centre = {-0.25f, 0.5f, 0},
       .spin_axis = {1, 0, 0},
       .spin_rad_per_frame = 0.03f},
      {.id = 3,
       .edge_length = 1,
       .centre = {0.5f, 0.25f, 0.75f},
       .spin_axis = {0, 0, 1},
       .spin_rad_per_frame = 0.05f},
  };
  return objects;
}

ObjectConstants objectConstants(const Object& object, int frame) {
  const float angle_rad = angleAt(object.spin_rad_per_frame, frame);
  return {glm::translate(glm::mat4(1), object.centre) *
          glm::rotate(glm::mat4(1), angle_rad, object.spin_axis)};
}

FrameBlock frameBlock(int frame) {
  FrameBlock block;
  block.camera_position = cameraPosition(frame);
  const glm::vec3 ahead = glm::normalize(-block.camera_position);  // to the origin
  const glm::mat4 view =
      glm::lookAtRH(block.camera_position, block.camera_position + ahead, glm::vec3(0, 1, 0));
  glm::mat4 projection = glm::perspectiveRH_ZO(
      glm::radians(45.0f), static_cast<float>(kWidth) / static_cast<float>(kHeight), 0.1f, 100.0f);
  projection[1][1] = -projection[1][1];  // Vulkan's y points down
  block.view_projection = projection * view;
  block.light_direction = {0.5f, 0.75f, 0.25f};
  return block;
}

}  // namespace embed
