// Reflections of a shiny, dented can after the Trashcan shader of ATI's Toyshop demo as Scherzer et al. 2012, section 5.1, tell it: 25
// stratified samples of an environment map around the mirror direction, weighted by a Gaussian, under a normal map.
#version 450
#extension GL_EXT_control_flow_attributes : require

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec4 world_tangent;
layout(location = 3) in vec2 uv;
layout(location = 0) out vec4 color;

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
} scene;
layout(set = 0, binding = 1) uniform sampler2D dent_map;
layout(set = 0, binding = 2) uniform sampler2D environment_map;

const float kPi = 3.14159265;
const float kConeWidth = 0.16;  // from sample to sample, as a tangent
const float kEnvironmentLod = 4.0;
// A Gaussian of variance 0.9 at the offsets, one in each of 5 x 5 strata; the weights add up to 1.
const vec2 kOffsets[25] = vec2[](
    vec2(-1.93, -1.85), vec2(-0.82, -1.73), vec2(0.14, -1.75), vec2(0.72, -2.02), vec2(2.27, -1.91),
    vec2(-1.76, -1.23), vec2(-1.02, -1.15), vec2(0.03, -0.96), vec2(0.71, -1.17), vec2(1.87, -0.75),
    vec2(-1.84, -0.20), vec2(-0.82, -0.22), vec2(0.00, 0.00), vec2(1.07, -0.22), vec2(1.70, 0.22),
    vec2(-2.17, 0.83), vec2(-0.71, 1.22), vec2(-0.13, 1.28), vec2(1.02, 1.11), vec2(1.82, 1.26),
    vec2(-1.89, 2.28), vec2(-0.76, 1.88), vec2(-0.08, 1.80), vec2(0.79, 1.74), vec2(1.88, 2.06));
const float kWeights[25] = float[](
    0.00320, 0.02214, 0.03061, 0.01318, 0.00128,
    0.01310, 0.04565, 0.10161, 0.05992, 0.01779,
    0.02529, 0.11366, 0.16963, 0.08742, 0.03315,
    0.00846, 0.05607, 0.06763, 0.04800, 0.01115,
    0.00130, 0.01727, 0.02794, 0.02231, 0.00225);
const vec3 kMetal = vec3(0.62, 0.64, 0.66);

// Latitude and longitude; the longitude's seam lies at -x.
vec3 environment(vec3 direction) {
  vec2 place = vec2(atan(direction.z, direction.x) * (0.5 / kPi) + 0.5, acos(clamp(direction.y, -1.0, 1.0)) / kPi);
  return textureLod(environment_map, place, kEnvironmentLod).rgb;
}

void main() {
  vec3 normal = normalize(world_normal);
  vec3 tangent = normalize(world_tangent.xyz - normal * dot(normal, world_tangent.xyz));
  vec3 bitangent = cross(normal, tangent) * world_tangent.w;
  vec3 bump = texture(dent_map, uv).xyz * 2.0 - 1.0;
  vec3 dented = normalize(bump.x * tangent + bump.y * bitangent + bump.z * normal);

  vec3 to_camera = normalize(scene.camera_position.xyz - world_position);
  vec3 mirrored = reflect(-to_camera, dented);
  vec3 across = normalize(cross(mirrored, vec3(0.31, 0.89, 0.33)));
  vec3 along = cross(mirrored, across);

  vec3 gathered = vec3(0.0);
  [[unroll]] for (int i = 0; i < 25; ++i) {
    vec2 offset = kConeWidth * kOffsets[i];
    gathered += kWeights[i] * environment(normalize(mirrored + offset.x * across + offset.y * along));
  }
  float grazing = pow(1.0 - max(dot(dented, to_camera), 0.0), 5.0);
  vec3 reflectance = mix(kMetal, vec3(1.0), grazing);
  vec3 lit = reflectance * gathered;
  color = vec4(lit / (1.0 + lit), 1.0);
}
