// Single scattering in a translucent body as Wang et al. 2005 factor it and Nehab et al. 2007, section 7.1, cache it: the sum over K = 4 terms of
// h_k(refracted view direction) * T_k(place). h_k lie in a texture; T_k gather four lights, dimmed on their way through an ellipsoid
// along which the view ray is sampled. Henyey-Greenstein phase function, g = -0.25.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 object_normal;
layout(location = 2) in vec3 object_camera;
layout(location = 0) out vec4 color;

layout(set = 0, binding = 1) uniform sampler2D view_terms;  // h_k of the refracted view direction, k in the channels

const int kTerms = 4;
const int kSteps = 4;
const float kG = -0.25;
const float kPi = 3.14159265;
const vec3 kExtinction = vec3(1.1, 1.9, 3.1);
const vec3 kLightDirections[kTerms] = vec3[](vec3(0.58, 0.58, 0.58), vec3(-0.74, 0.3, 0.6), vec3(0.2, 0.35, -0.915), vec3(-0.3, -0.9, -0.316));
const vec3 kLightColors[kTerms] = vec3[](vec3(5.2, 4.9, 4.5), vec3(2.1, 2.6, 3.4), vec3(6.5, 5.6, 4.2), vec3(1.2, 1.5, 1.1));

// From a point within the unit sphere along a unit direction to its surface.
float wayOut(vec3 point, vec3 direction) {
  float b = dot(point, direction);
  return -b + sqrt(max(b * b - dot(point, point) + 1.0, 0.0));
}

float phase(float cosine) {
  return (1.0 - kG * kG) / (4.0 * kPi * pow(1.0 + kG * kG - 2.0 * kG * cosine, 1.5));
}

void main() {
  vec3 normal = normalize(object_normal);
  vec3 incoming = normalize(object_position - object_camera);
  vec3 inside = refract(incoming, normal, 1.0 / 1.35);
  vec3 entry = normalize(object_position) * 0.999;
  float way = wayOut(entry, inside);
  vec2 view_place = vec2(atan(inside.z, inside.x) * (0.5 / kPi) + 0.5, acos(clamp(inside.y, -1.0, 1.0)) / kPi);
  vec4 view_term = textureLod(view_terms, view_place, 0.0);

  vec3 scattered = vec3(0.0);
  for (int k = 0; k < kTerms; ++k) {
    vec3 transfer = vec3(0.0);
    for (int i = 0; i < kSteps; ++i) {
      float gone = way * (float(i) + 0.5) / float(kSteps);
      vec3 place = entry + inside * gone;
      transfer += exp(-kExtinction * (gone + wayOut(place, kLightDirections[k])));
    }
    scattered += (0.5 + view_term[k]) * phase(dot(kLightDirections[k], -inside)) * kLightColors[k] * transfer * (way / float(kSteps)) * kExtinction;
  }
  float grazing = 0.04 + 0.96 * pow(1.0 - max(dot(normal, -incoming), 0.0), 5.0);
  float glint = pow(max(dot(reflect(incoming, normal), kLightDirections[0]), 0.0), 60.0);
  vec3 lit = (1.0 - grazing) * scattered + grazing * vec3(0.35, 0.4, 0.45) + 0.3 * glint;
  color = vec4(lit / (1.0 + lit), 1.0);
}
