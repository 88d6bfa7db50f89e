// expect: unshown image.constant
#version 450
layout(location = 0) in vec3 place;
layout(location = 0) out vec4 color;
// Black wherever it is drawn: all laws can be held, but nothing of a cache can show.
void main() { color = vec4(max(sin(place.x) - 5.0, 0.0)); }
