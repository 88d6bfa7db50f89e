// Parts of scenarios with passes, and one of a shadow map that a G-buffer reads, which the shader reads.
#pragma once

#include <string>

namespace reprise {

inline const char* const kSessions = R"(
[[session]]
name = "train"
role = "training"
camera = { eye = [0.3, 5, 4], target = [0, 0, 0], near = 0.5, far = 20 }
[[session]]
name = "check"
role = "validation"
camera = { eye = [0, 5, 4], target = [0, 0, 0] }
)";

inline const std::string kRender = R"(
[shader]
fragment = "a.frag"
[render]
width = 128
height = 128
frames = 24
cull = "none"
formats = ["rgba32_sfloat"]
clear = [-7, -7, -7, -7]
)";

inline const std::string kSun = R"(
[[pass]]
name = "shadow_map"
kind = "shadow"
size = 512
slope_bias = 3
light = { eye = [3, 6, 2], target = [0, 0, 0], orthographic = true, ortho_height = 8, near = 0.5, far = 14 }
)";

inline const std::string kTwoPasses = kRender + R"(
[[object]]
name = "ball"
mesh = { kind = "sphere", radius = 0.8 }
motion = { translate = { oscillate = { base = [0, 1.2, 0], amplitude = [1, 0, 0], period_s = 0.5 } } }
[[object]]
name = "floor"
mesh = { kind = "plane", size = 8 }
)" + kSun + R"(
[[pass]]
name = "light"
kind = "gbuffer"
fragment = "light.frag"
outputs = [{ texture = "light_map", format = "rgba32_sfloat" }]
[uniforms]
"Light.matrix" = { pass_view_projection = "shadow_map" }
"Light.place" = { pass_position = "shadow_map" }
)" + kSessions;

inline const char* const kLight = R"(#version 450
layout(location = 0) in vec3 world_position;
layout(location = 0) out vec4 result;
layout(set = 0, binding = 0, std140) uniform Light { mat4 matrix; vec3 place; };
layout(set = 0, binding = 1) uniform sampler2DShadow shadow_map;
void main() {
  vec4 at = matrix * vec4(world_position, 1);
  result = vec4(textureLod(shadow_map, vec3(at.xy * 0.5 + 0.5, at.z), 0.0), place);
}
)";

inline const char* const kShades = R"(#version 450
layout(location = 0) in vec3 world_position;
layout(location = 0) out vec4 result;
layout(set = 0, binding = 0) uniform sampler2D light_map;
void main() {
  vec4 light = texelFetch(light_map, ivec2(gl_FragCoord.xy), 0);
  float pattern = 0.0;
  for (int i = 1; i < 12; ++i) pattern += sin(world_position.x * float(i) + world_position.z) / float(i);
  result = vec4(pattern * (0.3 + 0.7 * light.r), light.gba);
}
)";

}  // namespace reprise
