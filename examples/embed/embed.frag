#version 450
// Stone with veins: noise in many octaves, which depends on the place on the object alone and is worth keeping from frame to
// frame, under a light whose highlight moves with the camera and has to be computed anew.

layout(set = 0, binding = 0) uniform Frame {
  mat4 view_projection;
  vec3 camera_position;
  vec3 light_direction;
} frame;

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;

layout(location = 0) out vec4 color;

float hash(vec3 cell) {
  cell = fract(cell * vec3(0.1031, 0.1030, 0.0973));
  cell += dot(cell, cell.yxz + 33.33);
  return fract((cell.x + cell.y) * cell.z);
}

float noise(vec3 point) {
  const vec3 cell = floor(point);
  const vec3 t = smoothstep(0.0, 1.0, point - cell);
  const vec2 unit = vec2(0.0, 1.0);
  const float x00 = mix(hash(cell + unit.xxx), hash(cell + unit.yxx), t.x);
  const float x10 = mix(hash(cell + unit.xyx), hash(cell + unit.yyx), t.x);
  const float x01 = mix(hash(cell + unit.xxy), hash(cell + unit.yxy), t.x);
  const float x11 = mix(hash(cell + unit.xyy), hash(cell + unit.yyy), t.x);
  return mix(mix(x00, x10, t.y), mix(x01, x11, t.y), t.z);
}

void main() {
  float veins = 0.0;
  float amplitude = 0.5;
  vec3 point = object_position * 3.0 + 7.0;
  for (int octave = 0; octave < 8; ++octave) {
    veins += amplitude * noise(point);
    amplitude *= 0.5;
    point = point.yzx * 2.03 + 1.7;
  }
  const float stone = smoothstep(0.25, 0.75, veins);
  const vec3 albedo = mix(vec3(0.15, 0.13, 0.2), vec3(0.9, 0.85, 0.75), stone);

  const vec3 to_camera = normalize(frame.camera_position - world_position);
  vec3 n = normalize(world_normal);
  n = dot(n, to_camera) < 0.0 ? -n : n;
  const vec3 to_light = normalize(frame.light_direction);
  const float diffuse = max(dot(n, to_light), 0.0);
  const float highlight = pow(max(dot(n, normalize(to_light + to_camera)), 0.0), 32.0);
  color = vec4(albedo * (0.2 + 0.8 * diffuse) + vec3(0.4 * highlight), 1.0);
}
