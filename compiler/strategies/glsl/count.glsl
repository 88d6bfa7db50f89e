// The counting copy: which fragment won a pixel, and how many were shaded, overdraw included. Never timed.
#if INSTRUMENTED
layout(location = COUNT_LOCATION) out float reprise_kind;      // 1/255 hit, 2/255 miss
layout(location = COUNT_LOCATION + 1) out vec4 reprise_counts;  // added up: shaded hits, shaded misses
#endif

void repriseCount(bool hit) {
#if INSTRUMENTED
  reprise_kind = hit ? 1.0 / 255.0 : 2.0 / 255.0;
  reprise_counts = hit ? vec4(1.0, 0.0, 0.0, 0.0) : vec4(0.0, 1.0, 0.0, 0.0);
#endif
}

// A fragment that another pass finishes and counts.
void repriseCountNothing() {
#if INSTRUMENTED
  reprise_kind = 0.0;
  reprise_counts = vec4(0.0);
#endif
}
