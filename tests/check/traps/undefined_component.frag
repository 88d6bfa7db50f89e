// expect: untestable inputs.undefined
#version 450
layout(location = 0) in vec3 place;
layout(location = 0) out vec4 color;
// Three components are added to what nobody wrote: the image is whatever the device makes of it.
void main() {
  vec4 sum;
  sum.xyz += sin(place * 5.0);
  color = sum;
}
