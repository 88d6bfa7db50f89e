// What the application draws: a floor and two plates that turn in front of one another, seen by a camera that
// goes around them. All of it is a function of the frame number. embed.toml describes the same scene to
// Reprise; a test holds the images of both equal.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace embed {

inline constexpr std::uint32_t kWidth = 320, kHeight = 180;  // pixels

struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  // triangles
};

// A square in the plane y = 0 around the origin, facing up.
Mesh makeSquare(float edge_length);

// An object of the scene turns about its own centre. `id` names it to Reprise: it must stay the same from
// frame to frame, since it is how last frame's matrices are found again.
struct Object {
  std::uint64_t id = 0;
  float edge_length = 1;
  glm::vec3 centre{0};
  glm::vec3 spin_axis{0, 1, 0};
  float spin_rad_per_frame = 0;
};

const std::vector<Object>& sceneObjects();

// Bytes as the shaders see them: the push constants `Object` and the uniform block `Frame` (std140) of
// embed.vert.
struct ObjectConstants {
  glm::mat4 model{1};
};
struct FrameBlock {
  glm::mat4 view_projection{1};
  glm::vec3 camera_position{0};
  float unused = 0;
  glm::vec3 light_direction{0, 1, 0};
  float unused_too = 0;
};
static_assert(sizeof(ObjectConstants) == 64 && sizeof(FrameBlock) == 96);

ObjectConstants objectConstants(const Object& object, int frame);
FrameBlock frameBlock(int frame);

}  // namespace embed
