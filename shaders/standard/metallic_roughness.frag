#version 450
// glTF 2.0's metallic-roughness material (appendix B of its specification), lit by a latitude/longitude environment, sampled over
// the lobes, and by punctual lights; tone-mapped (Narkowicz 2015) and encoded as sRGB.
//
// Defines that the scenario's models and passes decide: NORMAL_MAP, ALPHA_MASK, DOUBLE_SIDED, LIGHTS (the number of lights), SHADOW_MAP
// (light 0 is that of the shadow pass). SAMPLES (of the environment, for each lobe) and SHADOW_SPREAD (texels from tap to tap) are the user's.
#ifndef SAMPLES
#define SAMPLES 12
#endif
#ifndef SHADOW_SPREAD
#define SHADOW_SPREAD 1.0
#endif
layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 color;
#ifdef NORMAL_MAP
layout(location = 4) in vec4 world_tangent;
#endif
layout(location = 0) out vec4 out_color;

layout(set = 0, binding = 0, std140) uniform StandardView { vec3 camera_position; };
layout(set = 0, binding = 1, std140) uniform StandardMaterial {
  vec4 base_color_factor;
  vec4 metallic_roughness;  // metallic, roughness, normal scale, occlusion strength
  vec4 emissive_factor;
  float alpha_cutoff;
};
#ifdef LIGHTS
layout(set = 0, binding = 2, std140) uniform StandardLights {
  vec4 light_position[LIGHTS];
  vec4 light_color[LIGHTS];
  vec4 light_direction[LIGHTS];
  int light_count;
};
#endif
layout(set = 0, binding = 3) uniform sampler2D base_color_map;
layout(set = 0, binding = 4) uniform sampler2D metallic_roughness_map;
#ifdef NORMAL_MAP
layout(set = 0, binding = 5) uniform sampler2D normal_map;
#endif
layout(set = 0, binding = 6) uniform sampler2D occlusion_map;
layout(set = 0, binding = 7) uniform sampler2D emissive_map;
layout(set = 0, binding = 8) uniform sampler2D environment_map;
#ifdef SHADOW_MAP
layout(set = 0, binding = 9, std140) uniform StandardShadow { mat4 shadow_view_projection; };
layout(set = 0, binding = 10) uniform sampler2DShadow shadow_map;
#endif

const float kPi = 3.14159265;

vec3 environment(vec3 direction, float lod) {
  vec2 place = vec2(atan(direction.x, direction.z) / (2.0 * kPi) + 0.5, acos(clamp(direction.y, -1.0, 1.0)) / kPi);
  return textureLod(environment_map, place, lod).rgb;
}

float radicalInverse(uint bits) { return float(bitfieldReverse(bits)) * 2.3283064365386963e-10; }

mat3 frameAbout(vec3 z) {
  vec3 x = normalize(cross(abs(z.y) < 0.99 ? vec3(0, 1, 0) : vec3(1, 0, 0), z));
  return mat3(x, cross(z, x), z);
}

float visibility(float n_l, float n_v, float alpha) {
  float a2 = alpha * alpha;
  return 0.5 / (n_l * sqrt(n_v * n_v * (1.0 - a2) + a2) + n_v * sqrt(n_l * n_l * (1.0 - a2) + a2) + 1e-5);
}

vec3 fresnel(vec3 f0, float cosine) { return f0 + (1.0 - f0) * pow(1.0 - cosine, 5.0); }

// How much of a light arrives: percentage-closer filtering over 4 x 4 taps (Reeves et al. 1987). What the light does not see is lit.
float shadowOf(int light) {
#ifdef SHADOW_MAP
  if (light == 0) {
    vec4 place = shadow_view_projection * vec4(world_position, 1.0);
    vec3 seen = vec3(place.xy / place.w * 0.5 + 0.5, place.z / place.w);
    vec2 texel = SHADOW_SPREAD / vec2(textureSize(shadow_map, 0));
    float sum = 0.0;
    for (int tap = 0; tap < 16; ++tap) {
      vec2 offset = vec2(float(tap & 3) - 1.5, float(tap >> 2) - 1.5) * texel;
      sum += textureLod(shadow_map, vec3(seen.xy + offset, seen.z), 0.0);
    }
    return place.w > 0.0 && seen.z <= 1.0 ? sum / 16.0 : 1.0;
  }
#endif
  return 1.0;
}

vec3 lightOf(vec3 normal, vec3 view, vec3 diffuse, vec3 f0, float alpha) {
  vec3 sum = vec3(0);
#ifdef LIGHTS
  for (int i = 0; i < LIGHTS; ++i) {
    vec3 to_light = light_position[i].w > 0.0 ? light_position[i].xyz - world_position : light_position[i].xyz;
    float distance2 = dot(to_light, to_light);
    vec3 l = to_light * inversesqrt(max(distance2, 1e-12));
    float arriving = light_position[i].w > 0.0 ? 1.0 / max(distance2, 1e-4) : 1.0;
    float range = light_color[i].w;
    if (range > 0.0) arriving *= clamp(1.0 - pow(distance2 / (range * range), 2.0), 0.0, 1.0);
    arriving *= smoothstep(light_direction[i].w, mix(light_direction[i].w, 1.0, 0.3), dot(-l, light_direction[i].xyz));
    vec3 h = normalize(l + view);
    float n_l = max(dot(normal, l), 0.0), n_v = max(dot(normal, view), 1e-3), n_h = max(dot(normal, h), 0.0);
    float a2 = alpha * alpha, d = n_h * n_h * (a2 - 1.0) + 1.0;
    vec3 f = fresnel(f0, max(dot(h, view), 0.0));
    vec3 shaded = (1.0 - f) * diffuse / kPi + f * visibility(n_l, n_v, alpha) * a2 / (kPi * d * d);
    sum += shaded * light_color[i].rgb * (n_l * arriving * shadowOf(i));
  }
#endif
  return sum;
}

vec3 encode(vec3 linear) {
  vec3 x = linear * 0.6;
  vec3 mapped = clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
  return mix(12.92 * mapped, 1.055 * pow(mapped, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, mapped));
}

void main() {
  vec4 base = texture(base_color_map, uv) * base_color_factor * color;
#ifdef ALPHA_MASK
  if (base.a < alpha_cutoff) discard;
#endif
  vec3 normal = normalize(world_normal);
#ifdef NORMAL_MAP
  vec3 bump = texture(normal_map, uv).xyz * 2.0 - 1.0;
  bump.xy *= metallic_roughness.z;
  vec3 tangent = normalize(world_tangent.xyz - normal * dot(normal, world_tangent.xyz));
  normal = normalize(mat3(tangent, cross(normal, tangent) * world_tangent.w, normal) * bump);
#endif
  vec3 view = normalize(camera_position - world_position);
#ifdef DOUBLE_SIDED
  if (dot(normal, view) < 0.0) normal = -normal;
#endif
  vec4 surface = texture(metallic_roughness_map, uv);
  float metallic = metallic_roughness.x * surface.b, roughness = clamp(metallic_roughness.y * surface.g, 0.06, 1.0);
  float alpha = roughness * roughness;
  vec3 diffuse = base.rgb * (1.0 - metallic), f0 = mix(vec3(0.04), base.rgb, metallic);
  float n_v = max(dot(normal, view), 1e-3);
  mat3 frame = frameAbout(normal);

  vec3 diffuse_light = vec3(0), specular_light = vec3(0);
  for (int i = 0; i < SAMPLES; ++i) {
    vec2 u = vec2((float(i) + 0.5) / float(SAMPLES), radicalInverse(uint(i)));
    float turn = 2.0 * kPi * u.y;
    vec3 around = vec3(cos(turn), sin(turn), 0);
    diffuse_light += environment(frame * vec3(around.xy * sqrt(u.x), sqrt(1.0 - u.x)), 5.0);
    float cosine = sqrt((1.0 - u.x) / (1.0 + (alpha * alpha - 1.0) * u.x));
    vec3 h = frame * vec3(around.xy * sqrt(1.0 - cosine * cosine), cosine);
    vec3 l = reflect(-view, h);
    float n_l = max(dot(normal, l), 0.0), v_h = max(dot(view, h), 0.0), n_h = max(dot(normal, h), 1e-3);
    specular_light += environment(l, roughness * 5.0) * fresnel(f0, v_h) * (4.0 * visibility(n_l, n_v, alpha) * n_l * v_h / n_h);
  }
  float occlusion = mix(1.0, texture(occlusion_map, uv).r, metallic_roughness.w);
  vec3 ambient = (diffuse * diffuse_light * (1.0 - fresnel(f0, n_v)) + specular_light) * (occlusion / float(SAMPLES));
  vec3 emitted = texture(emissive_map, uv).rgb * emissive_factor.rgb;
  out_color = vec4(encode(ambient + lightOf(normal, view, diffuse, f0, alpha) + emitted), 1);
}
