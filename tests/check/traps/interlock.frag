// expect: refused device.capability
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_ARB_fragment_shader_interlock : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(pixel_interlock_ordered) in;
layout(set = 0, binding = 0, rgba8) uniform image2D trail;
void main() {
  vec3 base = marble(place);
  beginInvocationInterlockARB();
  imageStore(trail, ivec2(gl_FragCoord.xy), vec4(base, 1.0));
  endInvocationInterlockARB();
  color = vec4(base, 1.0);
}
