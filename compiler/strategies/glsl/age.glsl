// The counting copy that tells ages too: the frames since a hit's payload was computed.
#if AGED
float reprise_age_of_hit = 1.0;  // where none is fetched payloads are of the frame before
#endif
