// The counting copy: which fragment won a pixel, and how many were shaded, overdraw included. Never timed.
#if INSTRUMENTED
#if AGED
layout(location = COUNT_LOCATION) out vec2 reprise_kind_and_age;  // 1 hit, 2 miss; frames, up to 255
#else
layout(location = COUNT_LOCATION) out float reprise_kind;      // 1/255 hit, 2/255 miss
#endif
layout(location = COUNT_LOCATION + 1) out vec4 reprise_counts;  // added up: shaded hits, shaded misses
#endif

void repriseCount(bool hit) {
#if INSTRUMENTED
#if AGED
  reprise_kind_and_age = hit ? vec2(1.0, reprise_age_of_hit) : vec2(2.0, 0.0);
#else
  reprise_kind = hit ? 1.0 / 255.0 : 2.0 / 255.0;
#endif
  reprise_counts = hit ? vec4(1.0, 0.0, 0.0, 0.0) : vec4(0.0, 1.0, 0.0, 0.0);
#endif
}

// A fragment that another pass finishes and counts.
void repriseCountNothing() {
#if INSTRUMENTED
#if AGED
  reprise_kind_and_age = vec2(0.0);
#else
  reprise_kind = 0.0;
#endif
  reprise_counts = vec4(0.0);
#endif
}
