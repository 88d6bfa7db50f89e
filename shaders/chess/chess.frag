// Chess men under an open sky: object-space ambient occlusion from discs (Bunnell, GPU Gems 2, chapter 14), as Scherzer et al. 2012,
// section 5.1, tell it: the men that stand and the king that moves are summed apart. A diffuse texture, Blinn-Phong.
#version 450

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 uv;
layout(location = 0) out vec4 color;

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
  vec4 light_direction;
  vec4 king_position;
} scene;
layout(set = 0, binding = 1) uniform sampler2D wood_map;
layout(set = 0, binding = 2) uniform sampler2D standing_discs;  // a man a row, in the world
layout(set = 0, binding = 3) uniform sampler2D king_discs;      // one row, as the king's mesh lies

const float kPi = 3.14159265;
const float kFar = 3.0;  // in radii: from there on a man is one disc

// How much of the hemisphere over the receiver the disc hides. A disc without a normal faces everybody.
float occlusionBy(vec3 center, float area, vec3 disc_normal, vec3 normal) {
  vec3 to_disc = center - world_position;
  float squared = dot(to_disc, to_disc) + 1e-4;
  vec3 direction = to_disc * inversesqrt(squared);
  float facing = dot(disc_normal, disc_normal) > 0.0 ? clamp(-dot(disc_normal, direction), 0.0, 1.0) : 0.25;
  float above = clamp(4.0 * dot(normal, direction), 0.0, 1.0) * clamp(dot(normal, direction), 0.0, 1.0);
  return (1.0 - inversesqrt(area / (kPi * squared) + 1.0)) * facing * above;
}

float occlusionByRow(sampler2D discs, int row, vec3 offset, vec3 normal) {
  vec4 whole = texelFetch(discs, ivec2(0, row), 0);
  float radius = texelFetch(discs, ivec2(1, row), 0).w;
  if (distance(whole.xyz + offset, world_position) > kFar * radius) return occlusionBy(whole.xyz + offset, whole.w, vec3(0.0), normal);
  float sum = 0.0;
  int texels = textureSize(discs, 0).x;
  for (int i = 2; i < texels; i += 2) {
    vec4 place = texelFetch(discs, ivec2(i, row), 0);
    sum += occlusionBy(place.xyz + offset, place.w, texelFetch(discs, ivec2(i + 1, row), 0).xyz, normal);
  }
  return sum;
}

void main() {
  vec3 normal = normalize(world_normal);

  float standing_occlusion = 0.0;
  int men = textureSize(standing_discs, 0).y;
  for (int row = 0; row < men; ++row) standing_occlusion += occlusionByRow(standing_discs, row, vec3(0.0), normal);
  float king_occlusion = occlusionByRow(king_discs, 0, scene.king_position.xyz, normal);
  float open = exp(-1.8 * (standing_occlusion + king_occlusion));

  vec3 albedo = texture(wood_map, uv).rgb;
  ivec2 square = ivec2(floor(world_position.xz));
  if (world_position.y < 0.005 && ((square.x + square.y) & 1) != 0) albedo *= 0.4;
  vec3 to_light = normalize(scene.light_direction.xyz);
  vec3 halfway = normalize(to_light + normalize(scene.camera_position.xyz - world_position));
  float diffuse = max(dot(normal, to_light), 0.0);
  float specular = diffuse > 0.0 ? pow(max(dot(normal, halfway), 0.0), 40.0) : 0.0;
  vec3 lit = albedo * (0.75 * open + 0.45 * diffuse) + 0.2 * open * specular;
  color = vec4(lit, 1.0);
}
