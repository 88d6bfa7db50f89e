// Surfaces that say which they are: the payload is a label of object and place; the other outputs hold both
// as they are, for the test that hits fetch the surface that they show.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(push_constant) uniform Object {
  mat4 model;
  mat3 normal_matrix;
} object;

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 labelled;  // label, light
layout(location = 1) out vec4 place;     // position in the object's space, number of the object
layout(location = 2) out vec4 facing;    // normal in world space

// Within an object labels are places in world units times this. Those of other objects are far away.
const float kLabelPerUnit = 0.25;
const vec3 kLabelOf[3] = vec3[](vec3(0.5), vec3(1.5), vec3(0.3, -0.3, 0.3));

// Nearly its argument, at the cost of a material.
vec3 toil(vec3 label) { return tan(atan(tan(atan(label)))); }

void main() {
  // Objects 0, 1 and 2 are scaled by 1, 1/2 and 1/4.
  float scale = pow(determinant(mat3(object.model)), 1.0 / 3.0);
  int number = int(round(-log2(scale)));
  vec3 plain_label = kLabelOf[number] + kLabelPerUnit * scale * object_position;
  vec3 label = tan(atan(toil(toil(plain_label))));
  labelled = vec4(label, lightSurface(label, world_position, world_normal).x);
  place = vec4(object_position, float(number));
  facing = vec4(normalize(world_normal), 1.0);
}
