// What a difference between two images of one shader is judged to be, on the evidence (the design's law 0).
//
// A difference is rounding only if it is little (profiler/metrics/rounding.h), and a witness says that the computation is the same: the
// bits agree once no operation may be fused (NoContraction on both sides), or the reference interpreter finds equal terms. Everything
// else is ours.
#pragma once

#include "profiler/metrics/rounding.h"

namespace reprise {

// What the reference interpreter says of two modules (kUnknown: it cannot read one of them).
enum class Computation { kSame, kDifferent, kUnknown };

struct Evidence {
  Nearness as_given = Nearness::kEqual;
  bool equal_without_contraction = false;  // bit for bit with NoContraction on both sides
  Computation interpreted = Computation::kUnknown;
};

enum class RoundingJudgement {
  kEqual,
  kRounded,   // little, and one witness
  kEnlarged,  // more than little, but both witnesses: the shader enlarges rounding errors itself
  kOurs
};
RoundingJudgement judge(const Evidence& evidence);

}  // namespace reprise
