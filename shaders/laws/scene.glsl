// What the shaders of the law tests read from the application, and the light that their tails add.
#ifndef LAWS_SCENE_GLSL
#define LAWS_SCENE_GLSL

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec3 camera_position;
  float shininess;
  vec3 light_position;
  float time_s;
} scene;

// Blinn-Phong over an albedo: depends on the camera, so that a cached image of it would be wrong.
vec3 lightSurface(vec3 albedo, vec3 position, vec3 surface_normal) {
  vec3 normal = normalize(surface_normal);
  vec3 to_light = normalize(scene.light_position - position);
  vec3 to_camera = normalize(scene.camera_position - position);
  float diffuse = max(dot(normal, to_light), 0.0);
  float specular = pow(max(dot(normal, normalize(to_light + to_camera)), 0.0), scene.shininess);
  return albedo * (0.2 + 0.7 * diffuse) + 0.3 * specular;
}

#endif
