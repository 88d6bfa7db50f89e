// What linking replaces: the user's shader as functions, and the payload between them and the frame.
PAYLOAD_VEC reprise_payload[TARGETS];
uint reprise_wanted;  // bit c: the pixel needs the value whose guard is channel c
void reprise_hit() {}
void reprise_miss() {}
void reprise_wants() {}
