// The state of a session at one frame: camera, objects, uniform values. Deterministic: a function of its arguments alone.
//
// World space is right-handed with y up as cameras have it by default; view space looks along -z. Clip space is Vulkan's: y
// down, z in [0, 1], with a viewport of positive height. Meshes wind counter-clockwise seen from outside, and the flip of y
// in the projection and that of the framebuffer's y axis cancel out: the front faces are
// VK_FRONT_FACE_COUNTER_CLOCKWISE. The depth buffer must be cleared to 1, with reverse_z cameras (depth_compare "greater"
// or "greater_or_equal") to 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "profiler/gltf/pose.h"
#include "profiler/scenario/scenario.h"
#include "runtime/package/interface.h"

namespace reprise {

// Of the front faces of all built-in meshes under FrameState::projection.
inline constexpr bool kFrontFaceCounterClockwise = true;

// What a pass sees the scene by: its light, or the camera.
struct PassView {
  glm::mat4 view{1}, projection{1};
  glm::vec3 position{0};
};

struct FrameState {
  int frame = 0;          // of the session; in stereo the moment, the same for both eyes
  float time_s = 0;       // frame * frame_time_s * session speed
  std::uint32_t width = 0, height = 0;
  glm::mat4 view{1}, projection{1};  // Vulkan clip space: y down, z in [0, 1]
  glm::vec3 camera_position{0};
  std::vector<glm::mat4> models;     // by object; of a skinned part without its node, as the joints hold that
  std::vector<GltfPose> poses;       // by model
  std::vector<glm::mat4> placements; // by model: its motion
  std::vector<PassView> pass_views;  // by pass
};

// View (looking at the target, or along -up's perpendicular where eye and target coincide), projection and models of a frame.
// In stereo frames 2k and 2k + 1 are the moment k seen from half an eye distance to the left and to the right of the camera, along
// its right axis: all else is that of frame k.
// model = translate * rotate_z * rotate_y * rotate_x * spin * scale; orbits and spins turn by their step * frame * speed.
FrameState evaluateFrame(const Scenario& scenario, const SessionSpec& session, int image);

// The same frame as a pass sees it: with its view, projection and camera position, and for a shadow pass its size.
FrameState seenByPass(const Scenario& scenario, const FrameState& state, std::size_t pass);

// The bytes of a uniform block or push-constant range for one object, by the scenario's bindings; members nobody binds stay
// zero. block_name is the one before the dot in UniformBinding::member. Values are laid out by the members' offsets and
// strides (std140, std430, scalar, row_major alike); numbers go to integer members rounded to the nearest. Sources and what
// they fill, as checkBindings has it:
//   view, projection, view_projection  mat4
//   model            mat4 or mat4x3
//   normal_matrix    the inverse transpose of the model's upper 3x3: mat3, mat3x4 or mat4 (the rest as in the unit matrix)
//   camera_position  vec3 or vec4 (w = 1)
//   time, frame      float, in seconds; int, uint or float
//   resolution       vec2, or vec4 with the inverses in z and w
std::vector<std::byte> fillBlock(const Scenario& scenario, const SessionSpec& session, const FrameState& state,
                                 std::size_t object, const std::string& block_name,
                                 const std::vector<BlockMember>& members, std::uint32_t size_bytes);

}  // namespace reprise
