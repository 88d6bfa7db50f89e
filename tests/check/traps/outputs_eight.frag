// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 1) out vec4 target_1;
layout(location = 2) out vec4 target_2;
layout(location = 3) out vec4 target_3;
layout(location = 4) out vec4 target_4;
layout(location = 5) out vec4 target_5;
layout(location = 6) out vec4 target_6;
layout(location = 7) out vec4 target_7;
void main() {
  vec3 base = marble(place);
  color = vec4(base, 1.0);
  target_1 = vec4(base.zxy * float(1), waves(place.x));
  target_2 = vec4(base.zxy * float(2), waves(place.x));
  target_3 = vec4(base.zxy * float(3), waves(place.x));
  target_4 = vec4(base.zxy * float(4), waves(place.x));
  target_5 = vec4(base.zxy * float(5), waves(place.x));
  target_6 = vec4(base.zxy * float(6), waves(place.x));
  target_7 = vec4(base.zxy * float(7), waves(place.x));
}
