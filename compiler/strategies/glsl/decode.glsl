// Code that is the same for each target of a payload.
#if TARGETS == 1
#define EACH_TARGET(DO) DO(0)
#elif TARGETS == 2
#define EACH_TARGET(DO) DO(0) DO(1)
#elif TARGETS == 3
#define EACH_TARGET(DO) DO(0) DO(1) DO(2)
#else
#define EACH_TARGET(DO) DO(0) DO(1) DO(2) DO(3)
#endif

// From what a history holds back to the payload.
void repriseDecode(PAYLOAD_VEC encoded[TARGETS], out PAYLOAD_VEC payload[TARGETS]) {
#if AFFINE
  const vec4 scale[TARGETS] = PAYLOAD_SCALE;
  const vec4 offset[TARGETS] = PAYLOAD_OFFSET;
#define DECODE(target) payload[target] = (encoded[target] - offset[target]) * (1.0 / scale[target]);
  EACH_TARGET(DECODE)
#else
  payload = encoded;
#endif
}
