// A depth prepass for shaders that discard: the shader without its colours, which leaves what decides the discards.
#include "body.glsl"

void main() { reprise_miss(); }
