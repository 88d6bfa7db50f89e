// For shaders that take implicit derivatives, which need four lanes of a quad on one path. Helper lanes have no vote.
bool repriseAnyOfQuad(bool yes) {
  float vote = yes && !gl_HelperInvocation ? 1.0 : 0.0;
  vote = min(vote + abs(dFdxFine(vote)), 1.0);
  vote = min(vote + abs(dFdyFine(vote)), 1.0);
  return vote != 0.0;
}
