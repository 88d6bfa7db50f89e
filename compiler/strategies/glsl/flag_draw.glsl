// A miss flags its object, so that the pass for the misses can leave out the others.
#if FLAGS_DRAWS
layout(set = REPRISE_SET, binding = 1, std140) uniform RepriseDraw { uint valid_last_frame; uint index; } reprise_draw;
layout(set = REPRISE_SET, binding = FLAGS_BINDING, std430) buffer RepriseFlags { uint reprise_flags[]; };

void repriseFlagDraw() { atomicOr(reprise_flags[reprise_draw.index], 1u); }
#else
void repriseFlagDraw() {}
#endif
