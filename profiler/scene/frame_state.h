// The state of a session at one frame: camera, objects, uniform values. Deterministic: a function of its arguments alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "profiler/scenario/scenario.h"
#include "runtime/package/interface.h"

namespace reprise {

struct FrameState {
  int frame = 0;
  float time_s = 0;       // frame * frame_time_s * session speed
  std::uint32_t width = 0, height = 0;
  glm::mat4 view{1}, projection{1};  // Vulkan clip space: y down, z in [0, 1]
  glm::vec3 camera_position{0};
  std::vector<glm::mat4> models;     // by object
};

FrameState evaluateFrame(const Scenario& scenario, const SessionSpec& session, int frame);

// The bytes of a uniform block or push-constant range for one object, by the scenario's bindings; members nobody binds stay
// zero. block_name is the one before the dot in UniformBinding::member.
std::vector<std::byte> fillBlock(const Scenario& scenario, const SessionSpec& session, const FrameState& state,
                                 std::size_t object, const std::string& block_name,
                                 const std::vector<BlockMember>& members, std::uint32_t size_bytes);

// True if the block's content differs from object to object (it holds model or normal_matrix).
bool isPerObject(const Scenario& scenario, const std::string& block_name);

}  // namespace reprise
