// expect: verified
// Derivatives of what is the same for the whole draw, loaded from everything but storage buffers: pixels that are not drawn read it, too.
#version 450
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D image;
layout(set = 0, binding = 1) uniform samplerBuffer texels;
layout(set = 0, binding = 2) uniform sampler2D map;
layout(set = 0, binding = 3) uniform Scene { float gain; } scene;
layout(push_constant) uniform Draw { float scale; } draw;
void main() {
  float s = 0.0;
  for (int i = 0; i < 24; ++i) s += sin(dot(place, vec3(float(i), 1.3, 0.7)));
  float from_image = imageLoad(image, ivec2(1, 1)).x + 0.5;
  float from_texels = texelFetch(texels, 1).x + 0.5;
  vec4 jumps = vec4(dFdx(from_image), dFdx(from_texels), dFdx(scene.gain), dFdx(draw.scale));
  vec3 mapped = texture(map, uv * from_image).rgb + texture(map, uv * from_texels).rgb + texture(map, uv * (draw.scale + scene.gain)).rgb;
  color = vec4(mapped + 0.02 * s, 1.0) + jumps * 100.0;
}
