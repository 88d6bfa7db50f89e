// What linking replaces: the user's shader as two functions, and the payload between them and the frame.
PAYLOAD_VEC reprise_payload;
uint reprise_payload_valid;
void reprise_hit() {}
void reprise_miss() {}
